#include "core/c/esm_package.h"

#include "core/c/failure.h"
#include "core/c/package_arrays.h"
#include "core/support/errors.h"

EsmPackage* esmOpenPackage(const char* file, EsmError* error) {
    return esm::guarded(error, static_cast<EsmPackage*>(nullptr), [&] {
        if (!file) throw esm::InvalidModel("no file is named");
        return new EsmPackage{
            esm::PackageArrays(std::make_shared<const esm::PackagedTissue>(esm::loadPackagedTissue(file)))};
    });
}

void esmFreePackage(EsmPackage* package) {
    delete package;
}

const EsmModel* esmModelOf(const EsmPackage* package) {
    return &package->arrays.model();
}
