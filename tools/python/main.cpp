// umbra78._core: the functions of session.hpp and a frame's planes, for module/__init__.py.
//
// A broken precondition of the core becomes an exception instead of stopping the interpreter
// (fixed/trap.hpp).
#include "tools/python/session.hpp"
#include "tools/study/grid.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <map>
#include <stdexcept>

namespace py = pybind11;
using namespace umbra78::tools;
using namespace umbra78::tools::python;

extern "C" void umbra78_trapped(const char* why) {
    throw std::logic_error(std::string("umbra78: internal error: ") + why);
}

namespace {

// An array that reads the frame's own memory and keeps it alive.
template <class Word>
py::array array_of(std::span<const Word> words, int size_px,
                   const std::shared_ptr<const Rendered>& frame) {
    auto* kept = new std::shared_ptr<const Rendered>(frame);
    const py::capsule owner(kept, [](void* p) {
        delete static_cast<std::shared_ptr<const Rendered>*>(p);
    });
    py::array_t<Word> made({size_px, size_px}, words.data(), owner);
    made.attr("setflags")(py::arg("write") = false);
    return made;
}

py::dict dict_of(const Scaling& s) {
    py::dict made;
    made["unit"] = s.unit;
    made["max"] = s.max;
    if (s.far > s.near) {
        made["near"] = s.near;
        made["far"] = s.far;
        made["perspective"] = s.perspective;
    }
    return made;
}

py::dict buffers_of(const std::shared_ptr<const Rendered>& frame) {
    py::dict made;
    for (const PlaneOf& plane : frame->job.planes()) {
        const Buffer buffer = frame->job.buffer(plane);
        made[py::str(buffer.name)] = std::visit(
            [&](auto words) { return array_of(words, buffer.size_px, frame); }, buffer.values);
    }
    return made;
}

py::dict scalings_of(const Rendered& frame) {
    py::dict made;
    for (const PlaneOf& plane : frame.job.planes())
        made[py::str(frame.job.buffer(plane).name)] = dict_of(scaling_of(frame, plane));
    return made;
}

// What truth sees, of a light; None where there is none.
py::object truth_of(const std::shared_ptr<const Rendered>& frame, std::size_t light) {
    if (light >= frame->truths.size() || !frame->truths[light]) return py::none();
    const Truth& truth = frame->truths[light]->truth;
    py::dict made;
    made["visible"] = array_of(std::span(truth.visible), truth.size, frame);
    made["lit"] = array_of(std::span(truth.lit), truth.size, frame);
    made["depth"] = array_of(std::span(truth.depth), truth.size, frame);
    made["unlit_side"] =
        array_of(std::span(frame->truths[light]->unlit_side), truth.size, frame);
    return made;
}

// An array of two dimensions as doubles, and what its numbers were before.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
NumberImage image_of(const std::string& name, const Doubles& array, int kind) {
    NumberImage image;
    image.name = name;
    image.height = static_cast<int>(array.shape(0));
    image.width = static_cast<int>(array.shape(1));
    image.kind = static_cast<NumberKind>(kind);
    const int bits = image.kind == NumberKind::u8 ? 8 : image.kind == NumberKind::u16 ? 16 : 32;
    if (!is_real(image.kind))
        image.max = static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1);
    image.values.assign(array.data(), array.data() + array.size());
    return image;
}

template <class Value>
py::array copied(const std::vector<Value>& values, int height, int width) {
    return py::array_t<Value>({height, width}, values.data());
}

py::tuple shadow_of_arrays(const Captured& asked) {
    Shadowed made;
    {
        const py::gil_scoped_release unlocked;
        made = shadow_of(asked);
    }
    const NumberImage& observer = asked.capture.observer;
    return py::make_tuple(made.report, copied(made.mask, observer.height, observer.width),
                          copied(made.error, observer.height, observer.width),
                          copied(made.spectrum, made.side, made.side));
}

}  // namespace

PYBIND11_MODULE(_core, m) {
    m.attr("version") = UMBRA78_VERSION;
    py::register_exception<SceneError>(m, "Error", PyExc_ValueError);
    const py::call_guard<py::gil_scoped_release> unlocked;

    py::class_<SceneText>(m, "SceneText")
        .def(py::init<std::string, std::string>())
        .def_readonly("text", &SceneText::text)
        .def_readonly("path", &SceneText::path);
    m.def("read_file", read_file, unlocked);
    m.def("paper_scene", paper_scene);
    py::class_<Rendered, std::shared_ptr<Rendered>>(m, "Rendered");
    m.def("draw", [](const SceneText& scene, const Overrides& set, bool truth,
                     int threads) {
        return std::const_pointer_cast<Rendered>(draw(scene, set, truth, threads));
    }, unlocked);
    m.def("report", [](const std::shared_ptr<Rendered>& frame) { return report_of(*frame); },
          unlocked);
    m.def("buffers", [](const std::shared_ptr<Rendered>& frame) { return buffers_of(frame); });
    m.def("scalings", [](const std::shared_ptr<Rendered>& frame) { return scalings_of(*frame); });
    m.def("truth", [](const std::shared_ptr<Rendered>& frame, std::size_t light) {
        return truth_of(frame, light);
    });
    m.def("plan", frame_plan, unlocked);
    m.def("trace", pixel_trace, unlocked);
    m.def("bias", bias_of, unlocked);
    m.def("bias_of_map", [](int map, const std::map<std::string, std::string>& given,
                            bool reversed) {
        bias::MapOptions o;
        o.map_px = map;
        o.reversed = reversed;
        const std::map<std::string, std::string*> known{
            {"extent", &o.extent}, {"range", &o.range}, {"slope", &o.slope},
            {"azimuth", &o.azimuth}, {"depth", &o.depth}, {"filter", &o.filter}, {"z", &o.z},
            {"pixel", &o.pixel}};
        for (const auto& [name, value] : given) *known.at(name) = value;
        return bias_of_map(o);
    }, unlocked);
    m.def("study", [](const std::string& name, const std::optional<SceneText>& scene,
                      const std::vector<std::string>& vary, bool quick, bool automatic, int jobs) {
        return study_rows({name, scene, vary, quick, automatic, jobs});
    }, unlocked);
    py::class_<Captured>(m, "Captured")
        .def(py::init())
        .def_readwrite("least_bias", &Captured::least_bias)
        .def_readwrite("truth_bright", &Captured::truth_bright)
        .def("take", [](Captured& c, const std::string& name, const Doubles& array, int kind) {
            const NumberImage image = image_of(name, array, kind);
            if (name == "truth")
                c.truth = image;
            else
                (name == "observer_depth" ? c.capture.observer : c.capture.light) = image;
        })
        .def("means", [](Captured& c, const captured::Matrix16& matrix, const std::string& format,
                         const std::string& convention, const std::map<std::string, bool>& also) {
            c.capture.matrix = matrix;
            c.capture.matrix_name = "matrix";
            c.capture.format = depth_format_of(format);
            c.capture.convention = convention_of(convention);
            captured::Convention& to = c.capture.convention;
            const std::map<std::string, bool*> known{{"y_up", &to.y_up},
                                                     {"z_from_minus_one", &to.z_from_minus_one},
                                                     {"first_row_on_top", &to.first_row_on_top},
                                                     {"row_vectors", &to.row_vectors}};
            for (const auto& [name, value] : also) *known.at(name) = value;
        })
        .def("use", [](Captured& c, const Overrides& set) { c.capture.set = set; })
        .def("trace", [](Captured& c, int x, int y) { c.pixel = Pixel{x, y}; });
    m.def("shadow", shadow_of_arrays);
    m.def("studies", studies);
    m.def("settings", settings_table);
    m.def("figure_settings", figure_settings);
}
