#include "tests/support/inventor_scene.h"

#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/actions/SoWriteAction.h>
#include <Inventor/fields/SoMFFloat.h>
#include <Inventor/fields/SoMFInt32.h>
#include <Inventor/fields/SoMFString.h>
#include <Inventor/fields/SoMFVec3f.h>
#include <Inventor/lists/SoFieldList.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>
#include <Inventor/nodes/SoTexture2.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoOutput.h>
#include <Inventor/SoPrimitiveVertex.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace esm::test {

namespace {

/// Nodes of a type, those of types that follow from it as well.
SoPathList nodesOfType(SoNode* root, SoType type) {
    SoSearchAction search;
    search.setType(type);
    search.setInterest(SoSearchAction::ALL);
    search.apply(root);
    return search.getPaths();
}

SoNode* modelIn(SoNode* root) {
    const SoPathList found = nodesOfType(root, SoType::fromName("UnknownNode"));
    return found.getLength() == 1 ? found[0]->getTail() : nullptr;
}

/// Coin writes eight digits of a float, which may be its neighbour when they are read again.
bool isWrittenAlike(float first, float second) {
    return std::abs(first - second) <= 1.2e-7F * std::abs(first);
}

/// Fields of types that hold no floats must agree exactly.
bool isSameField(const SoField& field, const SoField& other) {
    const auto* floats = dynamic_cast<const SoMFFloat*>(&field);
    const auto* others = dynamic_cast<const SoMFFloat*>(&other);
    if (floats && others)
        return std::equal(floats->getValues(0), floats->getValues(0) + floats->getNum(), others->getValues(0),
                          others->getValues(0) + others->getNum(), isWrittenAlike);
    const auto* vectors = dynamic_cast<const SoMFVec3f*>(&field);
    const auto* otherVectors = dynamic_cast<const SoMFVec3f*>(&other);
    if (!vectors || !otherVectors) return field.isSame(other);
    bool isSame = vectors->getNum() == otherVectors->getNum();
    for (int i = 0; isSame && i < vectors->getNum(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            isSame = isSame && isWrittenAlike((*vectors)[i][axis], (*otherVectors)[i][axis]);
    return isSame;
}

void addInventorTriangle(void* list, SoCallbackAction* /*action*/, const SoPrimitiveVertex* first,
                         const SoPrimitiveVertex* second, const SoPrimitiveVertex* third) {
    InventorTriangle triangle;
    const std::array corners{first, second, third};
    for (std::size_t i = 0; i < 3; ++i) {
        const SbVec3f& place = corners[i]->getPoint();
        const SbVec4f& texture = corners[i]->getTextureCoords();
        triangle.places[i] = {place[0], place[1], place[2]};
        triangle.texture[i] = {texture[0], texture[1]};
    }
    static_cast<std::vector<InventorTriangle>*>(list)->push_back(triangle);
}

} // namespace

struct InventorScene::Scene {
    SoSeparator* root = nullptr;
    SoNode* model = nullptr;

    ~Scene() {
        if (root) root->unref();
    }
    template<class Field> const Field& field(const char* name) const {
        const auto* found = dynamic_cast<const Field*>(model->getField(name));
        if (!found) throw std::runtime_error(std::string("the model has no such field ") + name);
        return *found;
    }
};

InventorScene::InventorScene(const std::filesystem::path& file) : m_scene(std::make_shared<Scene>()) {
    SoDB::init();
    SoInput input;
    if (!input.openFile(file.c_str())) throw std::runtime_error("Coin opens no " + file.string());
    m_scene->root = SoDB::readAll(&input);
    if (!m_scene->root) throw std::runtime_error("Coin cannot read " + file.string());
    m_scene->root->ref();
    m_scene->model = modelIn(m_scene->root);
    if (!m_scene->model) throw std::runtime_error("no node, or several, in " + file.string());
}

InventorScene::~InventorScene() = default;

std::vector<float> InventorScene::floats(const char* field) const {
    const auto& values = m_scene->field<SoMFFloat>(field);
    return {values.getValues(0), values.getValues(0) + values.getNum()};
}

std::vector<std::int32_t> InventorScene::integers(const char* field) const {
    const auto& values = m_scene->field<SoMFInt32>(field);
    return {values.getValues(0), values.getValues(0) + values.getNum()};
}

std::vector<std::string> InventorScene::words(const char* field) const {
    const auto& values = m_scene->field<SoMFString>(field);
    std::vector<std::string> words;
    for (int i = 0; i < values.getNum(); ++i)
        words.emplace_back(values[i].getString());
    return words;
}

std::vector<Eigen::Vector3f> InventorScene::vectors(const char* field) const {
    const auto& values = m_scene->field<SoMFVec3f>(field);
    std::vector<Eigen::Vector3f> vectors;
    for (int i = 0; i < values.getNum(); ++i)
        vectors.emplace_back(values[i][0], values[i][1], values[i][2]);
    return vectors;
}

bool InventorScene::has(const char* field) const {
    return m_scene->model->getField(field) != nullptr;
}

std::vector<InventorTriangle> InventorScene::triangles() const {
    std::vector<InventorTriangle> triangles;
    SoCallbackAction action;
    action.addTriangleCallback(SoShape::getClassTypeId(), addInventorTriangle, &triangles);
    action.apply(m_scene->root);
    return triangles;
}

std::size_t InventorScene::lineCount() const {
    SoGetPrimitiveCountAction count;
    count.apply(m_scene->root);
    return static_cast<std::size_t>(count.getLineCount());
}

std::size_t InventorScene::pointCount() const {
    SoGetPrimitiveCountAction count;
    count.apply(m_scene->root);
    return static_cast<std::size_t>(count.getPointCount());
}

std::vector<Image> InventorScene::pages() const {
    std::vector<Image> pages;
    const SoPathList found = nodesOfType(m_scene->root, SoTexture2::getClassTypeId());
    for (int i = 0; i < found.getLength(); ++i) {
        SbVec2s size;
        int channels = 0;
        const unsigned char* bytes =
            static_cast<SoTexture2*>(found[i]->getTail())->image.getValue(size, channels);
        Image page{size[0], size[1], {}};
        for (int row = page.height - 1; row >= 0; --row)
            for (int x = 0; x < page.width; ++x) {
                const unsigned char* pixel = bytes + channels * (row * page.width + x);
                page.pixels.insert(page.pixels.end(), {pixel[0], pixel[1], pixel[2], 255});
            }
        pages.push_back(std::move(page));
    }
    return pages;
}

Eigen::Vector3f InventorScene::colour() const {
    const SoPathList found = nodesOfType(m_scene->root, SoMaterial::getClassTypeId());
    if (found.getLength() == 0) throw std::runtime_error("nothing has a material");
    const SbColor& colour = static_cast<SoMaterial*>(found[0]->getTail())->diffuseColor[0];
    return {colour[0], colour[1], colour[2]};
}

void InventorScene::write(const std::filesystem::path& file) const {
    SoOutput output;
    output.openFile(file.c_str());
    SoWriteAction(&output).apply(m_scene->root);
}

bool InventorScene::hasSameModelAs(const InventorScene& other) const {
    SoFieldList fields;
    const int count = m_scene->model->getFields(fields);
    for (int i = 0; i < count; ++i) {
        SbName name;
        m_scene->model->getFieldName(fields[i], name);
        const SoField* same = other.m_scene->model->getField(name);
        if (!same || !isSameField(*fields[i], *same)) return false;
    }
    SoFieldList others;
    return count > 0 && other.m_scene->model->getFields(others) == count;
}

} // namespace esm::test
