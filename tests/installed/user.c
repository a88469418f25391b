/* The same in C99, and each buffer of figures 3, 4 and 6 whose golden is a hash. */
#include <umbra78.h>

#include <stdio.h>
#include <stdlib.h>

static void check(umbra78_status status) {
    if (status == UMBRA78_OK) return;
    fprintf(stderr, "%s\n", umbra78_explain(status));
    exit(1);
}

static void print(const umbra78_frame* frame, const char* buffer, const char* golden) {
    umbra78_plane plane;
    check(umbra78_buffer(frame, buffer, 0, &plane));
    printf("%s u%d%s:%dx%d:fnv1a64:%016llx\n", golden, plane.bits, plane.bits == 8 ? "" : "be",
           plane.size_px, plane.size_px, (unsigned long long)umbra78_hash(&plane));
}

/* Memory from the heap, aligned by hand as C99 has to. */
static void* aligned(size_t bytes) {
    char* memory = malloc(bytes + UMBRA78_ALIGNMENT);
    if (memory == NULL) exit(1);
    return memory + (UMBRA78_ALIGNMENT - (size_t)(uintptr_t)memory % UMBRA78_ALIGNMENT);
}

static umbra78_frame* draw(int figure) {
    const umbra78_capacity capacity = {1, 128, 0, 0};
    umbra78_scene* scene;
    umbra78_frame* frame;
    size_t bytes = umbra78_scene_bytes(&capacity);
    check(umbra78_make_scene(&capacity, aligned(bytes), bytes, &scene));
    check(umbra78_take_figure(scene, figure));
    if (figure == 4) check(umbra78_set(scene, "dequantize", "1")); /* makes figure 5 of it */
    if (figure == 4) check(umbra78_set(scene, "low_pass", "2"));
    check(umbra78_frame_bytes(scene, &bytes));
    check(umbra78_render(scene, aligned(bytes), bytes, &frame));
    return frame;
}

int main(void) {
    const umbra78_frame *three = draw(3), *five = draw(4), *six = draw(6);
    uint64_t cycles = 0;
    print(three, "observer_z", "observer_z");
    print(three, "light_z", "light_z");
    print(three, "intensity", "intensity");
    print(three, "mask", "mask3");
    print(five, "mask", "mask4");
    print(five, "edges", "edges5");
    print(five, "filtered", "filtered5");
    print(six, "picture", "picture6");
    check(umbra78_cycles(six, &cycles));
    fprintf(stderr, "umbra78 %s: %llu cycles\n", umbra78_version(), (unsigned long long)cycles);
    return 0;
}
