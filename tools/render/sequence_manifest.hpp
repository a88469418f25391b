// The manifest of a sequence, frames.json: what each picture in the folder was made from.
//
// A picture's inputs are one hash of every word that it is made from: patches, materials, views and
// settings. Blanks in a scene file do not change it, a control point does. A picture is not drawn
// again if its inputs and its pixels still have the hashes in the manifest.
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

using SequenceManifest = std::vector<ManifestEntry>;

// "fnv1a64:0123456789abcdef"
std::string hash_inputs(const LoadedScene&);

// The manifest in `folder`; empty if there is none. Throws std::runtime_error if the file is not a
// manifest, so that somebody else's frames.json is not overwritten.
SequenceManifest read_manifest(const Path& folder);
void write_manifest(const Path& folder, const SequenceManifest&, FileSet& files);

// The entry whose picture exists, is intact and was made from these inputs; null if there is none.
const ManifestEntry* find_drawn(const SequenceManifest&, const Path& folder,
                                const std::string& file, const std::string& inputs);

}  // namespace umbra78::tools
