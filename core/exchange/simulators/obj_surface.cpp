#include "core/exchange/simulators/obj_surface.h"

#include "core/support/numbers.h"

#include <map>
#include <numeric>

namespace esm {

namespace {

std::string materialName(std::size_t page) {
    return "page-" + std::to_string(page + 1);
}

/// Places in the texture as the file lists them, each once.
class ObjPlaces {
public:
    explicit ObjPlaces(std::string& text) : m_text(text) {}

    /// Its number, from 1. @param place pixels from the top left @param size pixels
    std::size_t numberOf(const Eigen::Vector2d& place, int size) {
        const auto [known, isNew] = m_known.try_emplace({place.x(), place.y()}, m_known.size() + 1);
        if (isNew)
            m_text += "vt " + exactText(place.x() / size) + ' ' + exactText(1 - place.y() / size) + '\n';
        return known->second;
    }

private:
    std::string& m_text;
    std::map<std::pair<double, double>, std::size_t> m_known;
};

std::vector<std::vector<std::uint32_t>> trianglesByPage(const Project& project) {
    std::vector<std::vector<std::uint32_t>> pages(std::max<std::size_t>(1, texturePages(project)));
    for (std::uint32_t triangle = 0; triangle < project.mesh->triangles.size(); ++triangle)
        pages[project.atlas ? project.atlas->page[triangle] : 0].push_back(triangle);
    return pages;
}

/// Faces of one page, behind the places that they name.
void addPage(const Project& project, const std::vector<std::uint32_t>& triangles, ObjPlaces& places,
             std::string& faces) {
    for (const std::uint32_t triangle : triangles) {
        faces += 'f';
        for (std::size_t corner = 0; corner < 3; ++corner) {
            faces += ' ' + std::to_string(project.mesh->triangles[triangle][corner] + 1);
            if (project.atlas)
                faces += '/' + std::to_string(places.numberOf(project.atlas->corners[triangle][corner],
                                                              project.atlas->options.size));
        }
        faces += '\n';
    }
}

std::string objText(const Project& project, const Progress& progress) {
    std::string text = "mtllib surface.mtl\n", faces;
    for (const Eigen::Vector3d& vertex : project.mesh->vertices)
        text +=
            "v " + exactText(vertex.x()) + ' ' + exactText(vertex.y()) + ' ' + exactText(vertex.z()) + '\n';
    const auto pages = trianglesByPage(project);
    ObjPlaces places(text);
    for (std::size_t page = 0; page < pages.size(); ++page) {
        reportProgress(progress, static_cast<double>(page) / static_cast<double>(pages.size()));
        if (pages[page].empty()) continue;
        faces += "usemtl " + materialName(page) + '\n';
        addPage(project, pages[page], places, faces);
    }
    reportProgress(progress, 1);
    return text + faces;
}

/// The colour of the surface, or white beneath a texture, which is multiplied by it.
std::string mtlText(const Project& project, PictureFormat format) {
    std::string colour = "Kd";
    for (const std::uint8_t channel : project.texture.baseColour)
        colour += ' ' + roundedText(project.atlas ? 1.0 : channel / 255.0);
    std::string text;
    const std::size_t pages = texturePages(project);
    for (std::size_t page = 0; page < std::max<std::size_t>(1, pages); ++page) {
        text += "newmtl " + materialName(page) + '\n' + colour + '\n';
        if (page < pages) text += "map_Kd " + textureName(page, format) + '\n';
    }
    return text;
}

} // namespace

std::size_t texturePages(const Project& project) {
    return project.atlas ? static_cast<std::size_t>(project.atlas->options.pages) : 0;
}

std::string textureName(std::size_t page, PictureFormat format) {
    return "texture-" + std::to_string(page + 1) + endingOf(format);
}

void writeTexturePages(const Project& project, const std::filesystem::path& folder,
                       const HandoverMeans& means) {
    ProgressParts parts(means.progress);
    const BakedPages pages = bakedPages(project, parts.next(0.5));
    if (!pages.colours) return;
    const double share = 0.5 / static_cast<double>(pages.colours->size());
    for (std::size_t page = 0; page < pages.colours->size(); ++page) {
        const Bytes picture = encodePicture((*pages.colours)[page], means.pictures,
                                            project.atlas->texelsPerMetre, parts.next(share));
        writeFileAtomically(folder / textureName(page, means.pictures.format), picture);
    }
}

void writeObjSurface(const Project& project, const std::filesystem::path& folder,
                     const HandoverMeans& means) {
    ProgressParts parts(means.progress);
    writeFileAtomically(folder / "surface.obj", objText(project, parts.next(0.2)));
    writeFileAtomically(folder / "surface.mtl", mtlText(project, means.pictures.format));
    writeTexturePages(project, folder, withProgress(means, parts.rest()));
}

} // namespace esm
