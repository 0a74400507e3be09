#pragma once

#include "core/texture/image.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace esm::test {

/// A triangle as Coin would draw it.
struct InventorTriangle {
    std::array<Eigen::Vector3f, 3> places;
    std::array<Eigen::Vector2f, 3> texture; ///< from the lower left of its page
};

/// An Open Inventor file as Coin, a library that knows nothing of ours, reads it.
class InventorScene {
public:
    /// @throws std::runtime_error where Coin cannot read it or finds no spring-mass model
    explicit InventorScene(const std::filesystem::path& file);
    ~InventorScene();

    /// Fields of the spring-mass model. @throws std::runtime_error where there is none of that type
    std::vector<float> floats(const char* field) const;
    std::vector<std::int32_t> integers(const char* field) const;
    std::vector<std::string> words(const char* field) const;
    std::vector<Eigen::Vector3f> vectors(const char* field) const;
    bool has(const char* field) const;

    std::vector<InventorTriangle> triangles() const;
    std::size_t lineCount() const;
    std::size_t pointCount() const;
    std::vector<Image> pages() const; ///< from their top, as ours
    Eigen::Vector3f colour() const;   ///< of the first material

    /// In ASCII: Coin does not read again what it writes of nodes that it does not know in its binary form.
    void write(const std::filesystem::path& file) const;
    /// The same fields of the model; floats to the digits that Coin writes.
    bool hasSameModelAs(const InventorScene& other) const;

private:
    struct Scene;
    std::shared_ptr<Scene> m_scene;
};

} // namespace esm::test
