/* The machine for C, and by way of C for other languages and for a microcontroller.
 *
 * A scene and a frame are handles that lie in memory of the caller: nothing here allocates, throws,
 * prints or uses floating point. Settings go by the names that `umbra78 settings` lists and are
 * written as in a scene file. Every function returns a status, and umbra78_explain() says what it
 * means and what to do. The bits are those of the program. Scenes are in grey.
 *
 * Lengths are world words with 16 fraction bits (65536 is one world unit), angles degrees with 16
 * fraction bits. Memory is aligned to UMBRA78_ALIGNMENT bytes.
 *
 * Two threads may use two scenes. A handle is used by one thread at a time. */
#ifndef UMBRA78_H
#define UMBRA78_H

#include <stddef.h>
#include <stdint.h>

/* The version of the whole project: CMakeLists.txt reads it here. */
#define UMBRA78_VERSION_TEXT "0.1.0"
#define UMBRA78_ALIGNMENT 64

#if defined(__GNUC__)
#define UMBRA78_API __attribute__((visibility("default")))
#else
#define UMBRA78_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum umbra78_status {
    UMBRA78_OK = 0,
    UMBRA78_NULL_ARGUMENT,
    UMBRA78_NOT_ALIGNED,       /* memory */
    UMBRA78_MEMORY_TOO_SMALL,  /* ask for the bytes again: a rival may know only now */
    UMBRA78_SCENE_FULL,        /* more of something than umbra78_capacity says */
    UMBRA78_OUT_OF_WORLD,      /* a place beyond 32766 world units, or a length that is not one */
    UMBRA78_NO_SUCH_PART,      /* a material, vertex, light or number that is not there */
    UMBRA78_BAD_VIEW,
    UMBRA78_BAD_LEVEL,         /* of a material */
    UMBRA78_UNKNOWN_SETTING,
    UMBRA78_BAD_VALUE,         /* of a setting: no number or choice of it, or out of its range */
    UMBRA78_CANNOT_BE_BUILT,   /* the settings together; the one that was given is not taken */
    UMBRA78_NO_SUCH_BUFFER,
    /* what a frame refuses: shadow::FrameStatus, in its order */
    UMBRA78_NOT_BUILT = 100,
    UMBRA78_SPEC_OUT_OF_RANGE,
    UMBRA78_OBSERVER_MATRIX,
    UMBRA78_LIGHT_MATRIX,
    UMBRA78_SHADOW_MATRIX,
    UMBRA78_BIAS_OUT_OF_RANGE,
    UMBRA78_AREA_WHEN_DRAWN,
    UMBRA78_SECTORS_REFUSED,
    UMBRA78_NO_GROUND,
    UMBRA78_LIGHT_IN_GROUND,
    UMBRA78_RIVAL_OF_STREAM,
    UMBRA78_TOO_WIDE_FOR_RIVAL
} umbra78_status;

UMBRA78_API const char* umbra78_version(void);
/* One sentence with the remedy. */
UMBRA78_API const char* umbra78_explain(umbra78_status status);

/* --- a scene -------------------------------------------------------------------------------- */

typedef struct umbra78_scene umbra78_scene;

/* How many of each a scene has room for. A sphere takes 32 patches. */
typedef struct umbra78_capacity {
    size_t materials, patches, vertices, triangles;
} umbra78_capacity;

/* Grey levels 0 .. 255; the highlight's exponent is 2^shininess, 0 .. 8. */
typedef struct umbra78_material {
    int32_t diffuse, specular, shininess;
} umbra78_material;

/* The observer's view or a light's. Azimuth 0 is on the z axis, 90 degrees on the x axis. */
typedef struct umbra78_view {
    int perspective; /* 0: orthographic, of a light at infinity */
    int32_t azimuth_q16, elevation_q16;
    int32_t target_q16[3];
    int32_t extent_q16;         /* from the middle of the picture to its edge */
    int32_t distance_q16;       /* from the eye to the target; in perspective only */
    int64_t near_q16, far_q16;  /* of the target, or of the eye; both 0: fitted to the scene */
} umbra78_view;

UMBRA78_API size_t umbra78_scene_bytes(const umbra78_capacity* capacity);
/* A scene without surfaces and lights, with the machine's default settings: those of figure 3. */
UMBRA78_API umbra78_status umbra78_make_scene(const umbra78_capacity* capacity, void* memory,
                                              size_t bytes, umbra78_scene** scene);

/* `number` may be null; so may it be below. */
UMBRA78_API umbra78_status umbra78_add_material(umbra78_scene* scene,
                                                const umbra78_material* material,
                                                uint16_t* number);
UMBRA78_API umbra78_status umbra78_add_sphere(umbra78_scene* scene, const int32_t centre_q16[3],
                                              int32_t radius_q16, uint16_t material);
/* origin + s u + t v, 0 <= s, t <= 1 */
UMBRA78_API umbra78_status umbra78_add_plane(umbra78_scene* scene, const int32_t origin_q16[3],
                                             const int32_t u_q16[3], const int32_t v_q16[3],
                                             uint16_t material);
/* Control point (i, j) of a bicubic patch is 3 words from 3 (4 j + i) on. */
UMBRA78_API umbra78_status umbra78_add_patch(umbra78_scene* scene, const int32_t control_q16[48],
                                             uint16_t material);
UMBRA78_API umbra78_status umbra78_add_vertex(umbra78_scene* scene, const int32_t place_q16[3],
                                              uint32_t* number);
/* Flat, of three vertices. */
UMBRA78_API umbra78_status umbra78_add_triangle(umbra78_scene* scene, const uint32_t vertex[3],
                                                uint16_t material);
UMBRA78_API umbra78_status umbra78_set_observer(umbra78_scene* scene, const umbra78_view* view);
UMBRA78_API umbra78_status umbra78_add_light(umbra78_scene* scene, const umbra78_view* view);
/* A light at a place that looks at a target: its angles and its distance follow from them. */
UMBRA78_API umbra78_status umbra78_add_lamp(umbra78_scene* scene, const int32_t place_q16[3],
                                            const int32_t target_q16[3], int32_t extent_q16);
/* The paper's four spheres, 128 patches and a material, with its observer, its light and the
 * settings of one of its figures 1 .. 6. For a new scene. */
UMBRA78_API umbra78_status umbra78_take_figure(umbra78_scene* scene, int figure);

/* --- settings ------------------------------------------------------------------------------- */

/* "bias", "1.5"; "lookup", "bilinear"; "profile", "perspective24". */
UMBRA78_API umbra78_status umbra78_set(umbra78_scene* scene, const char* key, const char* value);
/* Writes the value as text with a final zero byte; 82 bytes hold each. */
UMBRA78_API umbra78_status umbra78_get(const umbra78_scene* scene, const char* key, char* value,
                                       size_t bytes);

typedef struct umbra78_setting {
    const char *key, *unit, *meaning;
    int64_t min, max; /* words: the value times 2^fraction; of a choice, its number */
    int fraction;
    size_t choices; /* 0: a number */
} umbra78_setting;

/* The table of settings, from number 0 on; UMBRA78_NO_SUCH_PART beyond its end. */
UMBRA78_API umbra78_status umbra78_setting_at(size_t number, umbra78_setting* setting);
/* The name of a choice; null if there is none of that number. */
UMBRA78_API const char* umbra78_choice_at(size_t setting, size_t choice);

/* --- a frame -------------------------------------------------------------------------------- */

typedef struct umbra78_frame umbra78_frame;

UMBRA78_API umbra78_status umbra78_frame_bytes(umbra78_scene* scene, size_t* bytes);
/* Draws the scene. It stays as it is, and lives, as long as the frame is used. */
UMBRA78_API umbra78_status umbra78_render(umbra78_scene* scene, void* memory, size_t bytes,
                                          umbra78_frame** frame);

/* size_px x size_px words of 8, 16 or 32 bits, row by row from the top, in the frame's memory. */
typedef struct umbra78_plane {
    const void* words;
    int bits, size_px;
} umbra78_plane;

/* observer_z, light_z, intensity, mask, edges, filtered, picture; all but the first, the third and
 * the last are of a light, numbered from 0. */
UMBRA78_API umbra78_status umbra78_buffer(const umbra78_frame* frame, const char* name,
                                          size_t light, umbra78_plane* plane);
/* FNV-1a-64 over the words, high byte first: what goldens hold. */
UMBRA78_API uint64_t umbra78_hash(const umbra78_plane* plane);
/* Of the machine, with its units side by side. Draws the views once more, to count. */
UMBRA78_API umbra78_status umbra78_cycles(const umbra78_frame* frame, uint64_t* cycles);

#ifdef __cplusplus
}
#endif

#endif
