#include "core/decoders/gltf_address.h"

#include "core/decoders/mesh_decoder.h"
#include "core/support/errors.h"
#include "tests/core/exchange/meshes/tetrahedron.h"
#include "tests/core/exchange/overwrite.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>

namespace esm {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// A folder with documents, beside a file that they must not reach.
class GltfAddress : public testing::Test {
protected:
    GltfAddress() {
        fs::create_directories(m_outer / "organs/parts");
        overwrite(m_outer / "secret.bin", tetrahedron::meshBuffer());
    }

    void put(const std::string& name) { overwrite(m_outer / ("organs/" + name), tetrahedron::meshBuffer()); }

    /// What comes of importing a document whose points and faces lie at the address.
    std::string errorOf(const std::string& address) {
        const fs::path file = m_outer / "organs/liver.gltf";
        nlohmann::json document = tetrahedron::gltfDocument();
        document["buffers"][0]["uri"] = address;
        overwrite(file, document.dump());
        try {
            return decodeMesh(file).polygons.size() == 4 ? "no error" : "another surface";
        } catch (const FileError& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            return error.what();
        }
    }

    void expectOutside(const std::string& address) {
        EXPECT_THAT(errorOf(address), AllOf(HasSubstr("liver.gltf"), HasSubstr("not in the folder")))
            << address;
    }

    TemporaryFolder m_outer;
};

TEST_F(GltfAddress, NamesFilesBesideTheDocumentAndBelow) {
    put("liver.bin");
    put("parts/liver left.bin");
    for (const char* address : {"liver.bin", "./liver.bin", "parts/../liver.bin", "parts/liver left.bin",
                                "parts/liver%20left.bin", "%6civer.bin"})
        EXPECT_EQ(errorOf(address), "no error") << address;
}

TEST_F(GltfAddress, NamesAFileThatIsCalledAsIfItWereEncoded) {
    put("liver%20left.bin");
    put("100%.bin");
    EXPECT_EQ(errorOf("liver%20left.bin"), "no error");
    EXPECT_EQ(errorOf("100%.bin"), "no error");
}

TEST_F(GltfAddress, LeavesTheFolderInNoWay) {
    const std::string secret = (m_outer / "secret.bin").string();
    for (const std::string& address :
         std::vector<std::string>{secret, "../secret.bin", "parts/../../secret.bin", "%2e%2e/secret.bin",
                                  "..%2Fsecret.bin", "file://" + secret, "FILE:" + secret, "..\\secret.bin",
                                  "%2e%2e%5csecret.bin", "C:\\secret.bin", "http://example.org/secret.bin"}) {
        expectOutside(address);
        EXPECT_THAT(errorOf(address), HasSubstr(address));
    }
    expectOutside("%2Fetc/passwd");
    expectOutside(std::string("liver.bin%00/../../secret.bin"));
    expectOutside("/dev/zero");
}

TEST_F(GltfAddress, FollowsLinksOnlyWithinTheFolder) {
    put("parts/liver.bin");
    fs::create_symlink("parts/liver.bin", m_outer / "organs/within.bin");
    fs::create_symlink("../secret.bin", m_outer / "organs/out.bin");
    fs::create_directory_symlink("..", m_outer / "organs/up");
    EXPECT_EQ(errorOf("within.bin"), "no error");
    expectOutside("out.bin");
    expectOutside("up/secret.bin");
    fs::create_directory_symlink("organs", m_outer / "linked");
    EXPECT_EQ(fileAtAddress(m_outer / "linked/liver.gltf", "parts/liver.bin").filename(), "liver.bin");
}

TEST_F(GltfAddress, OpensOnlyRegularFilesThatAreThere) {
    for (const char* address : {"parts", ".", "missing.bin"})
        EXPECT_THAT(errorOf(address), AllOf(HasSubstr(address), HasSubstr("not beside it"))) << address;
    EXPECT_THAT(errorOf("two\nlines.bin"), HasSubstr("two?lines.bin"));
}

TEST_F(GltfAddress, TakesADocumentNamedWithoutAFolder) {
    put("liver.bin");
    const fs::path before = fs::current_path();
    fs::current_path(m_outer / "organs");
    const fs::path found = fileAtAddress("liver.gltf", "liver.bin");
    fs::current_path(before);
    EXPECT_EQ(found, fs::canonical(m_outer / "organs/liver.bin"));
}

} // namespace
} // namespace esm
