#pragma once

#include "core/support/fields.h"

#include <array>

namespace esm {

/// What the editor's window is arranged for.
enum class Workspace { Tissue, Texture, Measure };
template<>
inline constexpr auto wordsOf<Workspace> =
    std::array{Word{Workspace::Tissue, "tissue"}, Word{Workspace::Texture, "texture"},
               Word{Workspace::Measure, "measure"}};

/// How the editor was left when the project was saved, so that it opens as it was. No edit changes it, and
/// nothing is computed by it.
struct EditorState {
    Workspace workspace = Workspace::Tissue;
    bool plays = true; ///< the tissue moves

    bool operator==(const EditorState&) const = default;
};
template<>
inline constexpr auto fieldsOf<EditorState> = fieldTable(field("workspace", &EditorState::workspace),
                                                         field("plays", &EditorState::plays));

} // namespace esm
