#include "tools/paper/goldens.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace umbra78::tools {
namespace {

Path picture_path(const Path& folder, const std::string& name) { return folder / (name + ".pgm"); }

GoldenCheck check(const Path& folder, const Buffer& buffer, const Hashes& hashes) {
    GoldenCheck result{buffer.name, {}, {}};
    Pgm golden{};
    try {
        golden = read_pgm(picture_path(folder, buffer.name));
    } catch (const std::runtime_error& error) {
        result.problem = error.what();
        return result;
    }
    if (golden.width != buffer.size_px || golden.height != buffer.size_px) {
        result.problem = fmt::format("the golden has {} x {} pixels, the buffer {} x {}",
                                     golden.width, golden.height, buffer.size_px, buffer.size_px);
        return result;
    }
    if (const auto difference = compare(golden, buffer)) {
        result.problem = fmt::format(
            "first at x {}, y {}: golden {}, drawn {}; {} of {} pixels differ", difference->x,
            difference->y, difference->expected, difference->actual, difference->pixels,
            buffer.pixels());
        result.picture = difference_picture(golden, buffer);
        return result;
    }
    const auto hash = hashes.find(buffer.name);
    if (hash == hashes.end())
        result.problem = "its picture is right, but hashes.txt has no line for it";
    else if (hash->second != hash_of(buffer))
        result.problem = fmt::format("its picture is right, but hashes.txt says {}, not {}",
                                     hash->second, hash_of(buffer));
    return result;
}

}  // namespace

Hashes read_hashes(const Path& folder) {
    Hashes hashes;
    std::ifstream file(folder / "hashes.txt");
    std::string name, hash;
    while (file >> name >> hash) hashes[name] = hash;
    return hashes;
}

void bless(const Path& folder, std::span<const Buffer> buffers, FileSet& set) {
    Hashes all = read_hashes(folder);
    for (const Buffer& buffer : buffers) {
        write_pgm(picture_path(folder, buffer.name), buffer, &set);
        all[buffer.name] = hash_of(buffer);
    }
    std::string hashes;
    for (const auto& [name, hash] : all) hashes += fmt::format("{} {}\n", name, hash);
    write_file(folder / "hashes.txt", std::as_bytes(std::span(hashes)), &set);
}

void require_goldens(const Path& folder) {
    if (read_hashes(folder).empty())
        throw std::runtime_error(
            fmt::format("there are no goldens in '{}'; name their folder with --goldens, or make "
                        "them with --bless", folder.string()));
}

std::vector<GoldenCheck> check(const Path& folder, std::span<const Buffer> buffers) {
    require_goldens(folder);
    const Hashes hashes = read_hashes(folder);
    std::vector<GoldenCheck> checks;
    for (const Buffer& buffer : buffers) checks.push_back(check(folder, buffer, hashes));
    return checks;
}

}  // namespace umbra78::tools
