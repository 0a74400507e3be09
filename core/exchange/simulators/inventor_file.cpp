#include "core/exchange/simulators/inventor_file.h"

#include "core/exchange/package/page_vertices.h"
#include "core/exchange/simulators/inventor_text.h"
#include "core/exchange/simulators/look_differences.h"
#include "core/exchange/simulators/model_tables.h"
#include "core/exchange/tissue_json.h"
#include "core/support/atomic_file.h"
#include "core/support/errors.h"
#include "core/texture/layers/composite.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace esm {

namespace {

/// Names of fields are those of a table and its column: "springsRestLength".
std::string inventorFieldName(const ModelTable& table, const TableColumn& column) {
    std::string name;
    bool isWordBegun = false;
    for (const char c : table.name + "_" + column.name) {
        if (c != '_') name += isWordBegun && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        isWordBegun = c == '_';
    }
    return name;
}

bool hasVectors(const TableColumn& column) {
    return std::holds_alternative<std::vector<double>>(column.values) && column.parts.size() == 3;
}

const char* inventorType(const TableColumn& column) {
    if (std::holds_alternative<std::vector<std::string>>(column.values)) return "MFString";
    if (std::holds_alternative<std::vector<std::int32_t>>(column.values)) return "MFInt32";
    return hasVectors(column) ? "MFVec3f" : "MFFloat";
}

std::string inventorValue(const std::string& value) {
    return inventorString(value);
}

std::string inventorValue(std::int32_t value) {
    return std::to_string(value);
}

std::string inventorValue(double value) {
    return inventorNumber(value);
}

std::string inventorPoint(const Eigen::Vector3d& point) {
    return inventorNumber(point.x()) + ' ' + inventorNumber(point.y()) + ' ' + inventorNumber(point.z());
}

bool fitsFloat(double value) {
    return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
}

/// @throws InvalidModel
void checkRange(const TriangleMesh& mesh, const std::vector<ModelTable>& tables) {
    std::vector<std::string> problems;
    const auto check = [&](const std::vector<double>& values, const std::string& what) {
        if (!std::all_of(values.begin(), values.end(), fitsFloat))
            problems.push_back(what +
                               " is beyond the range of Open Inventor's 32-bit numbers; vtu and obj have 64");
    };
    check(coordinatesOf(mesh.vertices), "a coordinate of a vertex");
    for (const ModelTable& table : tables)
        for (const TableColumn& column : table.columns)
            if (const auto* values = std::get_if<std::vector<double>>(&column.values))
                check(*values, "a number among the " + table.name + ", of " + column.name + ",");
    if (!problems.empty()) throw InvalidModel(problems);
}

/// The file's nodes one after the other.
class InventorFile {
public:
    explicit InventorFile(const std::filesystem::path& file) : m_file(file) {}

    void begin(const Project& project);
    void addModel(const std::vector<ModelTable>& tables, const Progress& progress);
    void addNetwork(const SpringNetwork& network);
    void addSurface(const Project& project, const std::vector<Eigen::Vector3d>& normals);
    void addPage(const PageVertices& vertices, const Image& page, const Progress& progress);
    void addFaces(const std::vector<Triangle>& triangles);
    void end(const Progress& progress);

private:
    void add(const std::string& line) { m_file.write(line + '\n'); }
    void addColumn(const ModelTable& table, const TableColumn& column);
    void addPicture(const Image& page, const Progress& progress);
    /// A field of many values. @param valueOf text of that place
    template<class ValueOf> void addList(const std::string& name, std::size_t count, ValueOf valueOf) {
        m_file.write(name + " [ ");
        for (std::size_t i = 0; i < count; ++i)
            m_file.write((i > 0 ? ",\n  " : "") + valueOf(i));
        add(" ]");
    }

    AtomicFile m_file;
};

void InventorFile::begin(const Project& project) {
    add("#Inventor V2.1 ascii\n");
    add("DEF " + inventorName(project.name) + " Separator {");
    add("Info { string " + inventorString(project.name + ", in SI units") + " }");
    add("Units { units METERS }");
}

void InventorFile::addColumn(const ModelTable& table, const TableColumn& column) {
    const std::size_t parts = partsOf(column);
    const std::string between = hasVectors(column) ? " " : ", ";
    const auto addRows = [&](const auto& values) {
        addList(inventorFieldName(table, column), rowCount(column), [&](std::size_t row) {
            std::string text = inventorValue(values[row * parts]);
            for (std::size_t part = 1; part < parts; ++part)
                text += between + inventorValue(values[row * parts + part]);
            return text;
        });
    };
    std::visit(addRows, column.values);
}

void InventorFile::addModel(const std::vector<ModelTable>& tables, const Progress& progress) {
    std::string fields;
    for (const ModelTable& table : tables)
        for (const TableColumn& column : table.columns)
            fields += (fields.empty() ? "" : ", ") + std::string(inventorType(column)) + ' ' +
                      inventorFieldName(table, column);
    add("EsmSpringMassModel {\nfields [ " + fields + " ]");
    ProgressParts parts(progress);
    for (const ModelTable& table : tables)
        for (const TableColumn& column : table.columns) {
            addColumn(table, column);
            reportProgress(parts.nextOfRest(0.2), 1);
        }
    add("}");
}

void InventorFile::addNetwork(const SpringNetwork& network) {
    const std::vector<Spring>& springs = network.springs;
    add("LightModel { model BASE_COLOR }\nCoordinate3 {");
    addList("point", network.restPositions.size(),
            [&](std::size_t node) { return inventorPoint(network.restPositions[node]); });
    if (springs.empty()) {
        add("}\nDrawStyle { pointSize 4 }\nPointSet { }");
        return;
    }
    add("}\nIndexedLineSet {");
    addList("coordIndex", springs.size(), [&](std::size_t spring) {
        return std::to_string(springs[spring].first) + ", " + std::to_string(springs[spring].second) + ", -1";
    });
    add("}");
}

/// What all pages share: an organ is seen from within as well, so that no side is left out.
void InventorFile::addSurface(const Project& project, const std::vector<Eigen::Vector3d>& normals) {
    const std::vector<Eigen::Vector3d>& vertices = project.mesh->vertices;
    add("ShapeHints { vertexOrdering COUNTERCLOCKWISE shapeType UNKNOWN_SHAPE_TYPE }");
    std::string colour;
    for (const std::uint8_t channel : project.texture.baseColour)
        colour += ' ' + inventorNumber(project.atlas ? 1 : channel / 255.0);
    add("Material { diffuseColor" + colour + " }");
    add("Coordinate3 {");
    addList("point", vertices.size(), [&](std::size_t vertex) { return inventorPoint(vertices[vertex]); });
    add("}\nNormal {");
    addList("vector", normals.size(), [&](std::size_t vertex) { return inventorPoint(normals[vertex]); });
    add("}\nNormalBinding { value PER_VERTEX_INDEXED }");
    // Mip-maps would mix patches that are not neighbours; up to this quality readers make none.
    if (project.atlas) add("Complexity { textureQuality 0.4 }");
}

/// Inventor's rows begin at the bottom.
void InventorFile::addPicture(const Image& page, const Progress& progress) {
    add("Texture2 { wrapS CLAMP wrapT CLAMP image " + std::to_string(page.width) + ' ' +
        std::to_string(page.height) + " 3");
    for (int row = page.height - 1; row >= 0; --row) {
        add(inventorPixels(page, row));
        if (row % 64 == 0) reportProgress(progress, 1 - static_cast<double>(row) / page.height);
    }
    add("}");
}

void InventorFile::addPage(const PageVertices& vertices, const Image& page, const Progress& progress) {
    ProgressParts parts(progress);
    const std::vector<std::uint32_t>& corners = vertices.corners;
    const auto face = [&](std::size_t triangle, auto numberOf) {
        std::string text;
        for (std::size_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
            text += std::to_string(numberOf(corners[corner])) + ", ";
        return text + "-1";
    };
    add("Separator {");
    addPicture(page, parts.next(0.8));
    add("TextureCoordinate2 {");
    addList("point", vertices.vertices.size(), [&](std::size_t drawn) {
        return inventorNumber(vertices.places[2 * drawn]) + ' ' +
               inventorNumber(1 - static_cast<double>(vertices.places[2 * drawn + 1]));
    });
    add("}\nTextureCoordinateBinding { value PER_VERTEX_INDEXED }\nIndexedFaceSet {");
    addList("coordIndex", corners.size() / 3, [&](std::size_t triangle) {
        return face(triangle, [&](std::uint32_t drawn) { return vertices.vertices[drawn]; });
    });
    addList("textureCoordIndex", corners.size() / 3,
            [&](std::size_t triangle) { return face(triangle, [](std::uint32_t drawn) { return drawn; }); });
    add("}\n}");
    reportProgress(parts.rest(), 1);
}

void InventorFile::addFaces(const std::vector<Triangle>& triangles) {
    add("IndexedFaceSet {");
    addList("coordIndex", triangles.size(), [&](std::size_t triangle) {
        const auto& [first, second, third] = triangles[triangle];
        return std::to_string(first) + ", " + std::to_string(second) + ", " + std::to_string(third) + ", -1";
    });
    add("}");
}

void InventorFile::end(const Progress& progress) {
    add("}");
    reportProgress(progress, 0);
    m_file.sync();
    reportProgress(progress, 1);
    m_file.commit();
}

void addPages(const Project& project, const std::vector<Image>& pages,
              const std::vector<Eigen::Vector3d>& normals, InventorFile& file, const Progress& progress) {
    ProgressParts parts(progress);
    const double share = 1 / static_cast<double>(pages.size());
    for (std::size_t page = 0; page < pages.size(); ++page) {
        std::vector<std::uint32_t> triangles;
        for (std::uint32_t triangle = 0; triangle < project.atlas->page.size(); ++triangle)
            if (project.atlas->page[triangle] == page) triangles.push_back(triangle);
        const Progress part = parts.next(share);
        if (!triangles.empty())
            file.addPage(pageVertices(project, normals, triangles, WithTangents::No), pages[page], part);
    }
}

} // namespace

void writeInventor(const Handover& handover, const std::filesystem::path& path, const HandoverMeans& means) {
    const Project& project = handover.project;
    const TriangleMesh& mesh = *project.mesh;
    ProgressParts parts(means.progress);
    std::vector<Image> pages;
    if (project.atlas)
        pages = composite(mesh, *project.atlas, project.layers, project.texture.baseColour, parts.next(0.5));
    const std::vector<ModelTable> tables = modelTables(handover);
    checkRange(mesh, tables);
    InventorFile file(path);
    file.begin(project);
    file.addModel(tables, parts.next(0.2));
    if (mesh.triangles.empty()) {
        file.addNetwork(*handover.tissue.network);
    } else {
        const std::vector<Eigen::Vector3d> normals = vertexNormals(mesh.vertices, mesh.triangles);
        file.addSurface(project, normals);
        if (project.atlas)
            addPages(project, pages, normals, file, parts.next(0.2));
        else
            file.addFaces(mesh.triangles);
    }
    file.end(parts.rest());
}

Differences inventorDifferences(const Handover& handover, const HandoverMeans& /*means*/) {
    Differences differences;
    differences.list = lookDifferences(handover.project, "an Open Inventor file");
    return differences;
}

} // namespace esm
