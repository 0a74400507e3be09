#include "core/render/gl_objects.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace esm;

namespace {

constexpr int smallLimit = 16; // pixels, and texels of a buffer

/// What was uploaded last to a driver that takes very little.
int uploadedWidth = 0, uploadedHeight = 0, attachments = 0;

void APIENTRY smallGetIntegerv(GLenum, GLint* value) {
    *value = smallLimit;
}

void APIENTRY recordTexImage2D(GLenum, GLint, GLint, GLsizei width, GLsizei height, GLint, GLenum, GLenum,
                               const void*) {
    uploadedWidth = width;
    uploadedHeight = height;
}

void APIENTRY recordTexBuffer(GLenum, GLenum, GLuint) {
    ++attachments;
}

void APIENTRY ignoreCount(GLsizei, GLuint*) {}
void APIENTRY ignoreConstCount(GLsizei, const GLuint*) {}
void APIENTRY ignoreBind(GLenum, GLuint) {}
void APIENTRY ignoreActive(GLenum) {}
void APIENTRY ignoreParameter(GLenum, GLenum, GLint) {}
void APIENTRY ignoreStore(GLenum, GLint) {}
void APIENTRY ignoreData(GLenum, GLsizeiptr, const void*, GLenum) {}

template<typename Function> void* address(Function* function) {
    return reinterpret_cast<void*>(function);
}

void* smallDriver(const char* name) {
    const std::string called = name;
    if (called == "glGetIntegerv") return address(smallGetIntegerv);
    if (called == "glTexImage2D") return address(recordTexImage2D);
    if (called == "glTexBuffer") return address(recordTexBuffer);
    if (called == "glGenTextures" || called == "glGenBuffers") return address(ignoreCount);
    if (called == "glDeleteTextures" || called == "glDeleteBuffers") return address(ignoreConstCount);
    if (called == "glBindTexture" || called == "glBindBuffer") return address(ignoreBind);
    if (called == "glTexParameteri") return address(ignoreParameter);
    if (called == "glPixelStorei") return address(ignoreStore);
    if (called == "glBufferData") return address(ignoreData);
    return address(ignoreActive); // with the rest, which is not called
}

Image picture(int width, int height) {
    Image image;
    image.width = width;
    image.height = height;
    image.pixels.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    return image;
}

} // namespace

TEST(GlTexture, APictureLargerThanTheDriverTakesIsHalvedUntilItFits) {
    const GlFunctions gl(smallDriver);
    GlTexture texture(gl);
    texture.upload(picture(16, 9), 0);
    EXPECT_EQ(uploadedWidth, 16);
    EXPECT_EQ(uploadedHeight, 9);
    texture.upload(picture(50, 8), 0);
    EXPECT_EQ(uploadedWidth, 13);
    EXPECT_EQ(uploadedHeight, 2);
}

TEST(GlTexture, MorePointsThanTheDriverTakesAreRefused) {
    const GlFunctions gl(smallDriver);
    GlBuffer buffer(gl);
    GlTexture texture(gl);
    const std::vector<float> texels(4 * (smallLimit + 1));
    attachments = 0;
    buffer.upload(GL_TEXTURE_BUFFER, texels.data(), smallLimit * sizeof(Eigen::Vector4f), GL_STATIC_DRAW);
    texture.attach(buffer);
    EXPECT_EQ(attachments, 1);
    buffer.upload(GL_TEXTURE_BUFFER, texels.data(), (smallLimit + 1) * sizeof(Eigen::Vector4f),
                  GL_STATIC_DRAW);
    EXPECT_THROW(texture.attach(buffer), std::runtime_error);
    EXPECT_EQ(attachments, 1);
}
