#include "tests/core/exchange/project/project_file_fixture.h"

namespace esm {
namespace {

using EditorJson = nlohmann::ordered_json;

TEST_F(ProjectFile, OpensInTheUsualWorkspaceWhereItDoesNotKnowTheOneItWasLeftIn) {
    const auto leaveIn = [this](const EditorJson& workspace) {
        const EditorJson editor{{"workspace", workspace}, {"plays", false}};
        changeManifest("", [&](EditorJson& manifest) { manifest["editor"] = editor; });
    };
    leaveIn("theatre");
    EXPECT_EQ(loadProject(m_file).editor, (EditorState{Workspace::Tissue, false}));
    leaveIn(7);
    EXPECT_NE(loadingError().find("editor.workspace"), std::string::npos);
}

} // namespace
} // namespace esm
