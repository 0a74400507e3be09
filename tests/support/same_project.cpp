#include "tests/support/same_project.h"

#include "core/exchange/fuzzy/fuzzy_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>

namespace esm {

namespace {

bool sameBits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

template<typename Matrix> bool sameMatrix(const Matrix& a, const Matrix& b) {
    return std::equal(a.data(), a.data() + a.size(), b.data(), sameBits);
}

template<typename List, typename Same> bool sameList(const List& a, const List& b, const Same& same) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

bool sameOptional(const std::optional<double>& a, const std::optional<double>& b) {
    return a.has_value() == b.has_value() && (!a || sameBits(*a, *b));
}

bool sameEllipsoid(const std::optional<Ellipsoid>& a, const std::optional<Ellipsoid>& b) {
    return a.has_value() == b.has_value() &&
           (!a || (sameMatrix(a->centre, b->centre) && sameMatrix(a->radii, b->radii) &&
                   sameMatrix(a->orientation.coeffs(), b->orientation.coeffs())));
}

void expectSameBinding(const std::optional<Binding>& a, const std::optional<Binding>& b) {
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) return;
    EXPECT_EQ(a->surface, b->surface);
    EXPECT_EQ(a->lines, b->lines);
    EXPECT_EQ(a->vertices.starts, b->vertices.starts);
    EXPECT_EQ(a->vertices.nodes, b->vertices.nodes);
    EXPECT_TRUE(sameList(a->vertices.shares, b->vertices.shares, sameBits));
}

void expectSameLattice(const Lattice& a, const Lattice& b) {
    EXPECT_EQ(a.filling.kind, b.filling.kind);
    EXPECT_TRUE(sameBits(a.filling.spacing, b.filling.spacing));
    EXPECT_TRUE(sameBits(a.filling.wallThickness, b.filling.wallThickness));
    EXPECT_EQ(a.filling.layers, b.filling.layers);
    EXPECT_EQ(a.tetrahedra, b.tetrahedra);
    EXPECT_EQ(a.surface, b.surface);
    EXPECT_TRUE(sameList(a.springShares, b.springShares, sameBits));
}

void expectSameSheet(const std::optional<SheetShares>& a, const std::optional<SheetShares>& b) {
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) return;
    EXPECT_TRUE(sameList(a->springs, b->springs, sameBits));
    EXPECT_TRUE(sameList(a->nodes, b->nodes, sameBits));
}

void expectSameMesh(const Project& a, const Project& b) {
    EXPECT_TRUE(sameList(a.mesh->vertices, b.mesh->vertices, sameMatrix<Eigen::Vector3d>));
    EXPECT_EQ(a.mesh->triangles, b.mesh->triangles);
    EXPECT_EQ(a.mesh->textureCoordinates, b.mesh->textureCoordinates);
    EXPECT_TRUE(sameList(a.network->restPositions, b.network->restPositions, sameMatrix<Eigen::Vector3d>));
    EXPECT_TRUE(sameList(a.network->springs, b.network->springs, [](const Spring& s, const Spring& t) {
        return s.first == t.first && s.second == t.second && sameBits(s.restLength, t.restLength);
    }));
    EXPECT_EQ(a.network->vertexNodes, b.network->vertexNodes);
    expectSameBinding(a.network->binding, b.network->binding);
    expectSameSheet(a.network->sheet, b.network->sheet);
    ASSERT_EQ(a.network->lattice.has_value(), b.network->lattice.has_value());
    if (a.network->lattice) expectSameLattice(*a.network->lattice, *b.network->lattice);
    EXPECT_EQ(a.source, b.source);
    forEachField(fieldsOf<RepairReport>, [&](const auto& field) {
        EXPECT_EQ((*a.importReport).*field.member, (*b.importReport).*field.member) << field.key;
    });
}

bool samePath(const Path& a, const Path& b) {
    return sameList(a, b, [](const PathPoint& p, const PathPoint& q) {
        return sameBits(p.time, q.time) && sameMatrix(p.value, q.value);
    });
}

void expectSameScene(const Scene& a, const Scene& b) {
    EXPECT_TRUE(sameBits(a.duration, b.duration));
    EXPECT_TRUE(sameMatrix(a.gravity, b.gravity));
    EXPECT_TRUE(sameList(a.fixed, b.fixed, [](const NodeSelection& s, const NodeSelection& t) {
        return s.nodes == t.nodes && sameEllipsoid(s.ellipsoid, t.ellipsoid);
    }));
    EXPECT_TRUE(sameList(a.tethers, b.tethers, [](const TetherRule& s, const TetherRule& t) {
        return s.every == t.every && sameBits(s.springConstant, t.springConstant) &&
               sameBits(s.viscosity, t.viscosity);
    }));
    EXPECT_TRUE(sameList(a.forces, b.forces, [](const NodeForce& s, const NodeForce& t) {
        return s.node == t.node && sameMatrix(s.force, t.force) && sameBits(s.from, t.from) &&
               sameBits(s.to, t.to);
    }));
    EXPECT_TRUE(sameList(a.moves, b.moves, [](const NodeMove& s, const NodeMove& t) {
        return s.node == t.node && samePath(s.path, t.path);
    }));
    EXPECT_TRUE(
        sameList(a.instruments, b.instruments, [](const InstrumentMotion& s, const InstrumentMotion& t) {
            return s.name == t.name && s.shape == t.shape && samePath(s.path, t.path) &&
                   sameList(s.orientations, t.orientations,
                            [](const auto& p, const auto& q) { return sameMatrix(p.coeffs(), q.coeffs()); });
        }));
    EXPECT_TRUE(sameBits(a.record.every, b.record.every));
    EXPECT_EQ(a.record.nodes, b.record.nodes);
}

void expectSamePhotos(const Project& a, const Project& b) {
    ASSERT_EQ(a.layers.size(), b.layers.size());
    for (std::size_t i = 0; i < a.layers.size(); ++i) {
        const TextureLayer &p = a.layers[i], &q = b.layers[i];
        EXPECT_EQ(p.name, q.name);
        ASSERT_EQ(p.photo == nullptr, q.photo == nullptr);
        if (p.photo) {
            EXPECT_EQ(p.photo->fileName, q.photo->fileName);
            EXPECT_EQ(p.photo->encoded, q.photo->encoded);
            EXPECT_EQ(p.photo->image.width, q.photo->image.width);
            EXPECT_EQ(p.photo->image.pixels, q.photo->image.pixels);
            EXPECT_EQ(pictureOf(p)->pixels, pictureOf(q)->pixels);
        }
        EXPECT_TRUE(sameMatrix(p.projector.pose.matrix(), q.projector.pose.matrix()));
        EXPECT_TRUE(sameBits(p.projector.width, q.projector.width));
        EXPECT_TRUE(sameBits(p.projector.height, q.projector.height));
        EXPECT_TRUE(p.projector == q.projector);
        EXPECT_TRUE(sameBits(p.blendPixels, q.blendPixels));
        EXPECT_TRUE(sameBits(p.opacity, q.opacity));
        EXPECT_EQ(p.visible, q.visible);
        EXPECT_TRUE(p.preparation == q.preparation);
        EXPECT_EQ(p.blending, q.blending);
        EXPECT_TRUE(p.strokes == q.strokes);
        EXPECT_EQ(p.landmarks, q.landmarks);
        EXPECT_EQ(p.finish, q.finish);
    }
}

void expectSameTexture(const Project& a, const Project& b) {
    const auto sameOptions = [](const AtlasOptions& o, const AtlasOptions& p) {
        return o.size == p.size && o.pages == p.pages && o.gap == p.gap && o.layout == p.layout &&
               sameBits(o.texelsPerMetre, p.texelsPerMetre);
    };
    EXPECT_TRUE(sameOptions(a.texture.atlas, b.texture.atlas));
    EXPECT_EQ(a.texture.baseColour, b.texture.baseColour);
    EXPECT_EQ(a.texture.finish, b.texture.finish);
    ASSERT_EQ(a.atlas == nullptr, b.atlas == nullptr);
    if (!a.atlas) return;
    EXPECT_TRUE(sameOptions(a.atlas->options, b.atlas->options));
    EXPECT_TRUE(sameBits(a.atlas->texelsPerMetre, b.atlas->texelsPerMetre));
    EXPECT_TRUE(sameBits(a.atlas->utilisation, b.atlas->utilisation));
    EXPECT_EQ(a.atlas->page, b.atlas->page);
    EXPECT_TRUE(sameList(a.atlas->corners, b.atlas->corners, [](const auto& s, const auto& t) {
        return sameList(s, t, sameMatrix<Eigen::Vector2d>);
    }));
}

} // namespace

void expectSameRegions(const std::vector<Region>& a, const std::vector<Region>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Region &r = a[i], &s = b[i];
        EXPECT_EQ(r.name, s.name);
        EXPECT_EQ(r.colour, s.colour);
        EXPECT_TRUE(sameEllipsoid(r.ellipsoid, s.ellipsoid));
        EXPECT_TRUE(sameBits(r.rim, s.rim));
        ASSERT_EQ(!r.system, !s.system);
        if (r.system) {
            EXPECT_EQ(toJson(*r.system), toJson(*s.system));
        }
        EXPECT_TRUE(sameList(r.inputs, s.inputs, [](const auto& x, const auto& y) {
            return x.first == y.first && sameBits(x.second, y.second);
        }));
        EXPECT_TRUE(sameOptional(r.held.springConstant, s.held.springConstant));
        EXPECT_TRUE(sameOptional(r.held.viscosity, s.held.viscosity));
        EXPECT_TRUE(sameOptional(r.held.mass, s.held.mass));
    }
}

void expectSameStepping(const std::optional<MeasuredStepping>& a, const std::optional<MeasuredStepping>& b) {
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) return;
    EXPECT_EQ(a->stepping.integrator, b->stepping.integrator);
    EXPECT_TRUE(sameBits(a->stepping.timeStep, b->stepping.timeStep));
    EXPECT_EQ(a->stepping.precision, b->stepping.precision);
    EXPECT_TRUE(sameBits(a->error, b->error));
    EXPECT_TRUE(sameBits(a->wallPerSimulatedSecond, b->wallPerSimulatedSecond));
    EXPECT_EQ(a->tissue, b->tissue);
}

void expectSameStiffening(const std::optional<SpringStiffening>& a,
                          const std::optional<SpringStiffening>& b) {
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) return;
    EXPECT_TRUE(sameBits(a->strain, b->strain));
    EXPECT_TRUE(sameBits(a->factor, b->factor));
}

void expectSameProject(const Project& a, const Project& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_TRUE(sameBits(a.base.springConstant, b.base.springConstant));
    EXPECT_TRUE(sameBits(a.base.viscosity, b.base.viscosity));
    EXPECT_TRUE(sameBits(a.base.mass, b.base.mass));
    expectSameStiffening(a.base.stiffening, b.base.stiffening);
    expectSameMesh(a, b);
    expectSameRegions(a.regions, b.regions);
    EXPECT_EQ(a.spareSystems, b.spareSystems);
    expectSameScene(a.scene, b.scene);
    expectSameStepping(a.stepping, b.stepping);
    EXPECT_EQ(a.accuracy, b.accuracy);
    expectSamePhotos(a, b);
    expectSameTexture(a, b);
}

} // namespace esm
