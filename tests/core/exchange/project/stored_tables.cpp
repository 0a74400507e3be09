#include "tests/core/exchange/project/stored_field_settings.h"

#include <algorithm>

/// What the tables beside the structs say is stored, so that a field that is added is tried without a word
/// here.
namespace esm::stored {

namespace {

template<class Member, class Number> Member filledWith(Number number) {
    if constexpr (std::is_arithmetic_v<Member>) {
        return number;
    } else if constexpr (requires { Member::Constant(number); }) {
        return Member::Constant(number);
    } else if constexpr (requires(Member member) { member.has_value(); }) {
        return filledWith<typename Member::value_type>(number);
    } else if constexpr (requires(Member member) { member.fill(number); }) {
        Member member;
        member.fill(number);
        return member;
    } else {
        return Member(1, filledWith<typename Member::value_type>(number));
    }
}

template<class Member, class Number> std::vector<Member> extremesOf(const Limits<Number>& limits) {
    return {filledWith<Member>(limits.least), filledWith<Member>(limits.most)};
}

/// None of what has a table of its own, or stands elsewhere in the file.
template<class Member> std::vector<Member> extremesOf(Unlimited) {
    if constexpr (std::is_same_v<Member, bool>) return {false, true};
    if constexpr (std::is_same_v<Member, std::size_t>) return {0, std::numeric_limits<Member>::max()};
    if constexpr (std::is_same_v<Member, std::uint32_t>) return {0, 7}; // a node
    if constexpr (std::is_same_v<Member, std::string>) return {"", "0123456789abcdef"};
    if constexpr (std::is_same_v<Member, std::array<std::uint8_t, 3>>) return {{0, 0, 0}, {255, 255, 255}};
    std::vector<Member> values;
    if constexpr (HasWords<Member>)
        for (const auto& [value, word] : wordsOf<Member>)
            values.push_back(value);
    return values;
}

template<class Struct, class Member, class Limit>
std::vector<Member> valuesOf(const FileField<Struct, Member, Limit>& field) {
    std::vector<Member> values = extremesOf<Member>(field.limits);
    if (field.presence != Presence::Always) values.push_back(Struct{}.*field.member);
    return values;
}

template<class Struct> using Change = std::function<void(Struct&)>;

/// @param within does a change to the struct wherever a project has it, if it does
/// @param others keys of what other parts of a project bound further
template<class Struct, class Within>
void addTable(Fields& fields, const std::string& place, const Within& within,
              const std::vector<std::string>& others = {}) {
    forEachField(fieldsOf<Struct>, [&](const auto& field) {
        if (std::find(others.begin(), others.end(), field.key) != others.end()) return;
        StoredField stored{place + '.' + field.key, {}};
        for (const auto& value : valuesOf(field))
            stored.settings.push_back([within, field, value](Project& project) {
                within(project, Change<Struct>([&](Struct& changed) {
                           if (field.belongsTo(changed)) changed.*field.member = value;
                       }));
            });
        if (!stored.settings.empty()) fields.push_back(stored);
    });
}

/// Changes a copy of what many share.
template<class Shared, class Struct> void replace(Shared& shared, const Change<Struct>& change) {
    auto copy = std::make_shared<Struct>(*shared);
    change(*copy);
    shared = std::shared_ptr<const Struct>(copy);
}

template<class Struct> auto firstOf(std::vector<Struct> Scene::*list) {
    return [list](Project& p, const Change<Struct>& change) {
        if (!(p.scene.*list).empty()) change((p.scene.*list).front());
    };
}

/// Masses are spread over nodes, of which each must keep one; stored_fields.cpp has them.
void addTissueTables(Fields& fields) {
    addTable<BaseTissue>(fields, "base", [](Project& p, const auto& change) { change(p.base); }, {"mass"});
    addTable<SpringStiffening>(fields, "base.stiffening", [](Project& p, const auto& change) {
        p.regions.clear();
        p.base.springConstant = 1;
        change(p.base.stiffening.emplace(SpringStiffening{1, 1}));
    });
    addTable<Region>(fields, "region", [](Project& p, const auto& change) {
        if (p.regions.size() > 1) change(p.regions[1]);
    });
    addTable<TissueValues>(fields, "region.held",
                           [](Project& p, const auto& change) {
                               if (p.regions.size() > 1) change(p.regions[1].held);
                           },
                           {"mass"});
    addTable<Ellipsoid>(fields, "region.ellipsoid", [](Project& p, const auto& change) {
        if (p.regions.size() > 1 && p.regions[1].ellipsoid) change(*p.regions[1].ellipsoid);
    });
    const auto inSystem = [](Project& p, const Change<FuzzySystem>& change) {
        if (p.regions.size() > 1 && p.regions[1].system) replace(p.regions[1].system, change);
    };
    addTable<FuzzySystem>(fields, "region.system", inSystem);
    addTable<FuzzyNorms>(fields, "region.system.norms", [=](Project& p, const auto& change) {
        inSystem(p, [&](FuzzySystem& system) { change(system.norms); });
    });
    const auto withStepping = [](Project& p) -> MeasuredStepping& {
        if (!p.stepping) p.stepping = MeasuredStepping{{Integrator::Rk4, 1, Precision::Double}, 1, 1, ""};
        p.stepping->stepping.integrator = Integrator::Rk4;
        return *p.stepping;
    };
    addTable<MeasuredStepping>(fields, "stepping",
                               [=](Project& p, const auto& change) { change(withStepping(p)); });
    addTable<Stepping>(fields, "stepping",
                       [=](Project& p, const auto& change) { change(withStepping(p).stepping); });
}

void addAccuracyTables(Fields& fields) {
    const auto inAccuracy = [](Project& p, const Change<MeasuredAccuracy>& change) {
        if (p.accuracy) replace(p.accuracy, change);
    };
    const auto inRun = [=](Project& p, const Change<TradeoffRun>& change) {
        inAccuracy(p, [&](MeasuredAccuracy& accuracy) { change(accuracy.runs.front()); });
    };
    addTable<TradeoffRun>(fields, "accuracy.run", inRun, {"stable"});
    addTable<Stepping>(fields, "accuracy.run.stepping", [=](Project& p, const auto& change) {
        inRun(p, [&](TradeoffRun& run) { change(run.stepping); });
    });
    const auto inLeftOut = [=](Project& p, const Change<LeftOutRun>& change) {
        inAccuracy(p, [&](MeasuredAccuracy& accuracy) { change(accuracy.leftOut.front()); });
    };
    addTable<LeftOutRun>(fields, "accuracy.leftOut", inLeftOut);
    addTable<Stepping>(fields, "accuracy.leftOut.stepping", [=](Project& p, const auto& change) {
        inLeftOut(p, [&](LeftOutRun& run) { change(run.stepping); });
    });
    addTable<TradeoffReference>(fields, "accuracy.reference", [=](Project& p, const auto& change) {
        inAccuracy(p, [&](MeasuredAccuracy& accuracy) { change(accuracy.reference); });
    });
    addTable<Detail>(fields, "accuracy.detail", [=](Project& p, const auto& change) {
        inAccuracy(p, [&](MeasuredAccuracy& accuracy) { change(accuracy.detail); });
    });
}

void addEditorTables(Fields& fields) {
    addTable<EditorState>(fields, "editor",
                          [](Project& p, const auto& change) { change(p.editor.emplace()); });
}

void addSceneTables(Fields& fields) {
    addTable<Scene>(fields, "scene", [](Project& p, const auto& change) { change(p.scene); });
    addTable<NodeSelection>(fields, "fixed", firstOf(&Scene::fixed));
    addTable<TetherRule>(fields, "tethers", firstOf(&Scene::tethers));
    addTable<NodeForce>(fields, "forces", firstOf(&Scene::forces));
    addTable<NodeMove>(fields, "moves", firstOf(&Scene::moves));
    const auto filled = [](Project& p, const Change<FluidFilling>& change) {
        p.scene.fillings = {{0, 1}};
        change(p.scene.fillings.front());
    };
    addTable<FluidFilling>(fields, "fillings", filled, {"part"});
    addTable<Sphere>(fields, "instruments.sphere", [](Project& p, const auto& change) {
        p.scene.instruments = {{Sphere{1}, {{0, {1, 2, 3}}}, {}, {}}};
        change(std::get<Sphere>(p.scene.instruments.front().shape));
    });
    addTable<Capsule>(fields, "instruments.capsule", [](Project& p, const auto& change) {
        p.scene.instruments = {{Capsule{1, 1}, {{0, {1, 2, 3}}}, {}, {}}};
        change(std::get<Capsule>(p.scene.instruments.front().shape));
    });
    addTable<Recording>(fields, "record", [](Project& p, const auto& change) { change(p.scene.record); });
}

/// What a layer projects, and how, is bound to its kind; stored_photo_fields.cpp has that.
void addLayerTables(Fields& fields, std::size_t i) {
    const auto inLayer = [i](Project& p, const auto& change) {
        if (p.layers.size() > i) change(p.layers[i]);
    };
    std::vector<std::string> bound{"file", "preparation"};
    if (i == 3) bound.push_back("blending"); // nothing is painted in bands
    addTable<TextureLayer>(fields, "layer", inLayer, bound);
    addTable<Projector>(fields, "projector",
                        [=](Project& p, const auto& change) {
                            inLayer(p, [&](TextureLayer& layer) { change(layer.projector); });
                        },
                        {"kind"});
    addTable<Intrinsics>(fields, "intrinsics", [=](Project& p, const auto& change) {
        inLayer(p, [&](TextureLayer& layer) {
            if (layer.projector.hasIntrinsics()) change(*layer.projector.intrinsics);
        });
    });
    addTable<BrushStroke>(fields, "stroke",
                          [=](Project& p, const Change<BrushStroke>& change) {
                              inLayer(p, [&](TextureLayer& layer) {
                                  for (auto& stroke : layer.strokes)
                                      replace(stroke, change);
                              });
                          },
                          {"brush"});
    const auto inFinish = [=](Project& p, const Change<LayerFinish>& change) {
        inLayer(p, [&](TextureLayer& layer) { change(layer.finish.emplace()); });
    };
    addTable<LayerFinish>(fields, "finish", inFinish);
    addTable<SurfaceFinish>(fields, "finish.surface", [=](Project& p, const auto& change) {
        inFinish(p, [&](LayerFinish& finish) { change(finish.surface); });
    });
    addTable<LandmarkPair>(fields, "landmark", [=](Project& p, const auto& change) {
        inLayer(p, [&](TextureLayer& layer) { change(layer.landmarks.emplace_back()); });
    });
}

void addPreparationTables(Fields& fields) {
    const auto preparing = [](Project& p, const Change<PhotoPreparation>& change) {
        if (p.layers.size() < 2) return;
        PhotoPreparation preparation = p.layers[1].preparation;
        change(preparation);
        prepare(p.layers[1], preparation);
    };
    addTable<PhotoPreparation>(fields, "preparation", preparing);
    addTable<PhotoStroke>(fields, "preparation.strokes", [=](Project& p, const auto& change) {
        preparing(p, [&](PhotoPreparation& preparation) {
            preparation.strokes = {{{{5, 5}, {9, 5}, {5, 9}}, 20, 0, false}};
            change(preparation.strokes[0]);
        });
    });
    addTable<PhotoField>(fields, "preparation.field",
                         [=](Project& p, const auto& change) {
                             preparing(p, [&](PhotoPreparation& preparation) {
                                 const PhotoField ellipse{FieldShape::Ellipse, {5, 5}, {5, 4}, 0, {}, 2};
                                 change(preparation.field.emplace(ellipse));
                             });
                         },
                         {"shape", "corners"});
    addTable<Lens>(fields, "preparation.lens", [=](Project& p, const auto& change) {
        preparing(p, [&](PhotoPreparation& preparation) { change(preparation.lens.emplace()); });
    });
    addTable<Intrinsics>(fields, "preparation.lens", [=](Project& p, const auto& change) {
        preparing(p, [&](PhotoPreparation& preparation) { change(preparation.lens.emplace().camera); });
    });
    addTable<ColourAdjustment>(fields, "preparation.adjustment", [=](Project& p, const auto& change) {
        preparing(p, [&](PhotoPreparation& preparation) { change(preparation.adjustment = {}); });
    });
    addTable<ColourMatch>(fields, "preparation.colourMatch", [=](Project& p, const auto& change) {
        preparing(p, [&](PhotoPreparation& preparation) { change(preparation.match.emplace()); });
    });
}

} // namespace

void addTables(Fields& fields) {
    addTissueTables(fields);
    addSceneTables(fields);
    addAccuracyTables(fields);
    addEditorTables(fields);
    for (std::size_t i = 0; i < 4; ++i)
        addLayerTables(fields, i);
    addPreparationTables(fields);
    addTable<AtlasOptions>(fields, "texture", [](Project& p, const auto& change) {
        p.texture.atlas = {};
        change(p.texture.atlas);
    });
    addTable<TextureSettings>(fields, "texture", [](Project& p, const auto& change) { change(p.texture); });
    addTable<MeshSource>(fields, "source",
                         [](Project& p, const auto& change) {
                             change(p.source.emplace(MeshSource{"liver.stl", std::string(64, '7')}));
                         },
                         {"sha256"});
    addTable<RepairReport>(fields, "importReport", [](Project& p, const Change<RepairReport>& change) {
        replace(p.importReport, change);
    });
}

} // namespace esm::stored
