// What the statuses of umbra78.h mean, and what to do.
#include "shadow/c/umbra78.h"

extern "C" {

const char* umbra78_version(void) { return UMBRA78_VERSION_TEXT; }

const char* umbra78_explain(umbra78_status status) {
    switch (status) {
        case UMBRA78_OK: return "all is well";
        case UMBRA78_NULL_ARGUMENT: return "an argument is null; give all of them";
        case UMBRA78_NOT_ALIGNED:
            return "the memory is not aligned; align it to UMBRA78_ALIGNMENT bytes";
        case UMBRA78_MEMORY_TOO_SMALL:
            return "the memory is too small; ask for the bytes that are needed again, and give "
                   "as many";
        case UMBRA78_SCENE_FULL:
            return "the scene has no room left; make it with a larger umbra78_capacity (a sphere "
                   "takes 32 patches), with fewer lights, or build with the feature lights";
        case UMBRA78_OUT_OF_WORLD:
            return "a place is beyond 32766 world units, or a radius is not more than 0; scale "
                   "the scene";
        case UMBRA78_NO_SUCH_PART:
            return "there is no material, vertex, light, figure or setting of this number; add "
                   "it first, or count from 0";
        case UMBRA78_BAD_VIEW:
            return "a view is missing or out of range; give an observer and a light, an extent "
                   "and in perspective a distance of more than 0, angles up to 360 and 90 "
                   "degrees, and near less than far or both 0";
        case UMBRA78_BAD_LEVEL:
            return "a material's level is not within 0 .. 255, or its shininess not within 0 .. 8";
        case UMBRA78_UNKNOWN_SETTING:
            return "there is no setting of this name; umbra78_setting_at() lists them";
        case UMBRA78_BAD_VALUE:
            return "the setting has no such value; umbra78_setting_at() has its range, "
                   "umbra78_choice_at() its choices";
        case UMBRA78_CANNOT_BE_BUILT:
            return "no machine can be built with these settings together; set the others first, "
                   "or take another value";
        case UMBRA78_NO_SUCH_BUFFER:
            return "the frame has no such buffer; umbra78.h lists them, and a form without a "
                   "depth map has no light_z";
        case UMBRA78_NOT_BUILT:
            return "this build leaves out a stage that is asked for; build with more "
                   "UMBRA78_FEATURES";
        case UMBRA78_SPEC_OUT_OF_RANGE: return "a width of the machine is out of its range";
        case UMBRA78_OBSERVER_MATRIX:
            return "the observer's matrix does not fit the machine's words; bring its extent "
                   "nearer the scene's size";
        case UMBRA78_LIGHT_MATRIX:
            return "the light's matrix does not fit the machine's words; bring its extent nearer "
                   "the scene's size";
        case UMBRA78_SHADOW_MATRIX:
            return "the matrix from observer to light does not fit the machine's words; bring "
                   "their extents nearer each other, or lower the bias";
        case UMBRA78_BIAS_OUT_OF_RANGE: return "the bias is beyond 2^47 quanta; lower it";
        case UMBRA78_AREA_WHEN_DRAWN:
        case UMBRA78_SECTORS_REFUSED:
        case UMBRA78_NO_GROUND:
        case UMBRA78_LIGHT_IN_GROUND:
        case UMBRA78_RIVAL_OF_STREAM:
            return "this form asks for what a scene of umbra78.h has not; set form to "
                   "post_process";
        case UMBRA78_TOO_WIDE_FOR_RIVAL:
            return "a surface, the eye or a lamp lies too far from the observer's target for a "
                   "rival; raise the observer's extent, or set form to post_process";
    }
    return "there is no such status";
}

}  // extern "C"
