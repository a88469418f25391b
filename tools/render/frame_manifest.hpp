// The manifest of a sequence, frames.json: what each picture in the folder was made from.
//
// A frame's inputs are one hash of every word it is made from: patches, materials, views and
// settings, so that blanks in a scene file change nothing and a control point does. A picture of
// the same inputs whose pixels still have the hash in the manifest need not be drawn again.
#pragma once

#include "tools/io/files.hpp"
#include "tools/scene/scene_file.hpp"

#include <optional>
#include <string>
#include <vector>

namespace umbra78::tools {

struct ManifestEntry {
    std::string file, inputs, picture;  // "frame_0001.png", and two hashes
};

using Manifest = std::vector<ManifestEntry>;

// "fnv1a64:0123456789abcdef"
std::string hash_inputs(const LoadedScene&);

// Of `folder`; empty where there is none. Throws std::runtime_error for what is no manifest, so
// that somebody else's file is not written over.
Manifest read_manifest(const Path& folder);
void write_manifest(const Path& folder, const Manifest&, FileSet& files);

// The entry whose picture is there, whole, and made from these inputs.
const ManifestEntry* find_drawn(const Manifest&, const Path& folder, const std::string& file,
                                const std::string& inputs);

}  // namespace umbra78::tools
