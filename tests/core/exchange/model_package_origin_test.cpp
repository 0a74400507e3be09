#include "tests/core/exchange/model_package_fixture.h"

#include "core/exchange/package/xmp_packet.h"
#include "tests/core/exchange/strangers_reader.h"
#include "tests/support/exchange_projects.h"

namespace esm {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

const Authorship everything{"Liver \"A\" \xc3\xa4", "A. N. Other", "2026-05-17", "CC BY 4.0"};
const MeshSource liverFile{"liver 1.stl", std::string(60, 'a') + "0123"};

Project importedProject() {
    Project project = bareProject();
    project.source = liverFile;
    return project;
}

class PackageOrigin : public ModelPackageFile {
protected:
    Json exportedJson(const Project& project, const Authorship& authorship) const {
        exportPackage(project, m_file, saidBy(authorship));
        return parseGlb(readFile(m_file)).json;
    }
};

TEST_F(PackageOrigin, SaysWhatIsKnown) {
    exportPackage(importedProject(), m_file, saidBy(everything));
    const auto provenance = loadPackage(m_file).provenance;
    ASSERT_TRUE(provenance);
    EXPECT_THAT(provenance->program, HasSubstr("Elastodynamic Shape Modeler "));
    EXPECT_EQ(provenance->source, liverFile);
    EXPECT_EQ(provenance->authorship, everything);
    EXPECT_EQ(loadPackagedTissue(m_file).provenance, provenance);
    expectReadIndependently(importedProject(), m_folder.path(), saidBy(everything));
}

TEST_F(PackageOrigin, InventsNothing) {
    const Json json = exportedJson(bareProject(), {});
    const Json& provenance = json["extensions"]["ESM_spring_mass"]["provenance"];
    EXPECT_EQ(provenance, (Json{{"program", json["asset"]["generator"]}}));
    EXPECT_FALSE(json["extensions"].contains(xmpExtension));
    EXPECT_FALSE(json["asset"].contains("extensions"));
    const Json dated = exportedJson(bareProject(), {{}, {}, "2026", {}});
    EXPECT_EQ(dated["extensions"]["ESM_spring_mass"]["provenance"].size(), 2U);
    EXPECT_EQ(dated["extensions"][xmpExtension]["packets"][0]["xmp:CreateDate"], "2026");
}

TEST_F(PackageOrigin, SaysTheSameToCatalogues) {
    const Json json = exportedJson(importedProject(), everything);
    EXPECT_EQ(json["asset"]["extensions"][xmpExtension]["packet"], 0);
    EXPECT_THAT(json["extensionsUsed"].get<std::vector<std::string>>(), testing::Contains(xmpExtension));
    const Json& packet = json["extensions"][xmpExtension]["packets"][0];
    EXPECT_EQ(packet["dc:title"]["rdf:_1"]["@value"], everything.title);
    EXPECT_EQ(packet["dc:creator"]["@list"], Json::array({everything.author}));
    EXPECT_EQ(packet["xmp:CreateDate"], everything.date);
    EXPECT_EQ(packet["dc:rights"]["rdf:_1"]["@value"], everything.licence);
    EXPECT_EQ(packet["dc:source"], liverFile.file);
}

TEST_F(PackageOrigin, NoTextAndNoDateIsRefused) {
    const auto refusal = [&](const Authorship& authorship) {
        try {
            exportPackage(bareProject(), m_file, saidBy(authorship));
        } catch (const FileError& error) {
            return std::string(error.what());
        }
        return std::string("exported");
    };
    EXPECT_THAT(refusal({"\xff", {}, {}, {}}), HasSubstr("the title must be UTF-8"));
    EXPECT_THAT(refusal({{}, "a\nb", {}, {}}), HasSubstr("the author must be one line"));
    EXPECT_THAT(refusal({{}, {}, {}, std::string(1001, 'l')}), HasSubstr("the licence must have at most"));
    for (const char* date : {"today", "26", "2026-", "2026-13", "2026-02-30", "2026/05/17", "+026-05-17",
                             "2026-05-17T10:00", "20260517"})
        EXPECT_THAT(refusal({{}, {}, date, {}}), HasSubstr("the date must be")) << date;
    EXPECT_FALSE(std::filesystem::exists(m_file));
    for (const char* date : {"2026", "2026-05", "2024-02-29", "0001-01-01"})
        EXPECT_EQ(refusal({{}, {}, date, {}}), "exported") << date;
}

TEST_F(PackageOrigin, IsRefusedWhereItIsNone) {
    exportPackage(importedProject(), m_file, saidBy(everything));
    const Glb whole = parseGlb(readFile(m_file));
    const auto refusal = [&](const char* pointer, const Json& value) {
        Glb glb = whole;
        glb.json["extensions"]["ESM_spring_mass"]["provenance"][Json::json_pointer(pointer)] = value;
        rewrite(glb);
        EXPECT_THROW(loadPackagedTissue(m_file), FileError);
        return loadingError();
    };
    EXPECT_THAT(refusal("/source/sha256", "12"), HasSubstr("64 hexadecimal digits"));
    EXPECT_THAT(refusal("/source", 5), HasSubstr("provenance.source"));
    EXPECT_THAT(refusal("/program", nullptr), HasSubstr("program is missing"));
    EXPECT_THAT(refusal("/date", "yesterday"), HasSubstr("the date"));
    EXPECT_THAT(refusal("/author", 7), HasSubstr("author"));
    EXPECT_THAT(refusal("/program", "safe\x1b[2J"), HasSubstr("the program must be one line"));
    EXPECT_THAT(refusal("/program", std::string(1001, 'p')), HasSubstr("the program must have at most"));
    EXPECT_THAT(refusal("/source/file", "a\nb.stl"), HasSubstr("the file's name must be one line"));
    EXPECT_THAT(refusal("/source/file", std::string(1001, 'f')),
                HasSubstr("the file's name must have at most"));
}

TEST_F(PackageOrigin, IsNotAskedOfPackagesOfBefore) {
    exportPackage(importedProject(), m_file);
    Glb glb = parseGlb(readFile(m_file));
    glb.json["extensions"]["ESM_spring_mass"].erase("provenance");
    rewrite(glb);
    EXPECT_FALSE(loadPackage(m_file).provenance);
}

} // namespace
} // namespace esm
