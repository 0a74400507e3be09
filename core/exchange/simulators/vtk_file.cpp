#include "core/exchange/simulators/vtk_file.h"

#include "core/exchange/simulators/vtk_content.h"

namespace esm {

namespace {

/// Adds arrays while it reports what is done of all of a file's.
class VtkWriting {
public:
    VtkWriting(const std::string& kind, const VtkContent& content, const Progress& progress)
        : m_xml(kind), m_content(content), m_parts(progress) {}

    void add(const std::string& line) { m_xml.add(line); }
    void add(const VtkArray& array) {
        constexpr double ofWhatIsLeft = 0.1; // how large the others are is not known
        m_xml.addArray(array);
        reportProgress(m_parts.nextOfRest(ofWhatIsLeft), 1);
    }
    void addAll(const std::string& element, const std::vector<VtkArray>& arrays);
    void addPoints();
    void addCells(const std::string& kind, const VtkCells& cells);
    Bytes finished() const { return m_xml.finished(); }

private:
    VtkXml m_xml;
    const VtkContent& m_content;
    ProgressParts m_parts;
};

void VtkWriting::addAll(const std::string& element, const std::vector<VtkArray>& arrays) {
    const bool isOfPlaces = element != "FieldData";
    add('<' + element + (isOfPlaces ? R"( Scalars="spring_constant">)" : ">"));
    for (const VtkArray& array : arrays)
        add(array);
    add("</" + element + '>');
}

/// Points, what they have and what cells have stand in the same order in both kinds of file.
void VtkWriting::addPoints() {
    addAll("PointData", m_content.ofPoints);
    addAll("CellData", m_content.ofCells);
    add("<Points>");
    add(m_content.places);
    add("</Points>");
}

void VtkWriting::addCells(const std::string& kind, const VtkCells& cells) {
    add('<' + kind + '>');
    add({"connectivity", "", 1, cells.points});
    add({"offsets", "", 1, cells.ends});
    add("</" + kind + '>');
}

std::string countOf(const char* name, std::size_t number) {
    return std::string(" NumberOf") + name + "=\"" + std::to_string(number) + '"';
}

std::size_t pointCount(const VtkContent& content) {
    return std::get<std::vector<double>>(content.places.values).size() / 3;
}

Bytes vtpOf(const VtkContent& content, const Progress& progress) {
    VtkWriting writing("PolyData", content, progress);
    writing.addAll("FieldData", content.ofAll);
    writing.add("<Piece" + countOf("Points", pointCount(content)) +
                countOf("Verts", content.single.ends.size()) + countOf("Lines", content.lines.ends.size()) +
                countOf("Strips", 0) + countOf("Polys", content.triangles.ends.size()) + '>');
    writing.addPoints();
    writing.addCells("Verts", content.single);
    writing.addCells("Lines", content.lines);
    writing.addCells("Strips", {});
    writing.addCells("Polys", content.triangles);
    writing.add("</Piece>");
    return writing.finished();
}

/// All cells one after the other, and VTK's numbers of what each is.
struct VtkGrid {
    VtkCells cells;
    std::vector<std::uint8_t> types;

    void append(const VtkCells& more, std::uint8_t type) {
        const auto before = static_cast<std::int64_t>(cells.points.size());
        cells.points.insert(cells.points.end(), more.points.begin(), more.points.end());
        for (const std::int64_t end : more.ends)
            cells.ends.push_back(before + end);
        types.insert(types.end(), more.ends.size(), type);
    }
};

VtkGrid gridOf(const VtkContent& content) {
    constexpr std::uint8_t vertex = 1, line = 3, triangle = 5, tetrahedron = 10;
    VtkGrid grid;
    grid.append(content.single, vertex);
    grid.append(content.lines, line);
    grid.append(content.triangles, triangle);
    grid.append(content.tetrahedra, tetrahedron);
    return grid;
}

Bytes vtuOf(const VtkContent& content, const Progress& progress) {
    const VtkGrid grid = gridOf(content);
    VtkWriting writing("UnstructuredGrid", content, progress);
    writing.addAll("FieldData", content.ofAll);
    writing.add("<Piece" + countOf("Points", pointCount(content)) + countOf("Cells", grid.types.size()) +
                '>');
    writing.addPoints();
    writing.add("<Cells>");
    writing.add({"connectivity", "", 1, grid.cells.points});
    writing.add({"offsets", "", 1, grid.cells.ends});
    writing.add({"types", "", 1, grid.types});
    writing.add("</Cells>");
    writing.add("</Piece>");
    return writing.finished();
}

/// @param bytesOf a file of that content
template<class BytesOf>
void writeVtk(const Handover& handover, VtkVolumes volumes, const std::filesystem::path& file,
              const HandoverMeans& means, BytesOf bytesOf) {
    ProgressParts parts(means.progress);
    const VtkContent content = vtkContentOf(handover, volumes, parts.next(0.2));
    const Bytes bytes = bytesOf(content, parts.next(0.6));
    reportProgress(parts.next(0.05), 0);
    writeFileAtomically(file, bytes, parts.rest());
}

} // namespace

void writeVtp(const Handover& handover, const std::filesystem::path& file, const HandoverMeans& means) {
    writeVtk(handover, VtkVolumes::No, file, means, vtpOf);
}

void writeVtu(const Handover& handover, const std::filesystem::path& file, const HandoverMeans& means) {
    writeVtk(handover, VtkVolumes::Yes, file, means, vtuOf);
}

Differences vtuDifferences(const Handover& handover, const HandoverMeans& /*means*/) {
    Differences differences;
    if (handover.project.atlas)
        differences.list.push_back({"VTK's XML has no texture",
                                    "the surface can be coloured by its tissue; a .glb keeps its photos"});
    return differences;
}

Differences vtpDifferences(const Handover& handover, const HandoverMeans& means) {
    Differences differences = vtuDifferences(handover, means);
    if (handover.tissue.network->lattice)
        differences.list.push_back(
            {"PolyData has no cells for tetrahedra",
             "their nodes stand in the array tetrahedra_nodes; a .vtu has them as cells"});
    return differences;
}

} // namespace esm
