# Compiles the fuzzy systems of presets/ and the tissues of presets/tissue/ into esm_core, so that the program needs no
# folder of its own at run time.
function(esm_preset_entries folder entries)
  set(text "")
  foreach(preset ${ARGN})
    set(preset_file ${folder}/${preset}.json)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${preset_file})
    file(READ ${preset_file} preset_json)
    string(APPEND text "    {\"${preset}\", R\"json(${preset_json})json\"},\n")
  endforeach()
  set(${entries} "${text}" PARENT_SCOPE)
endfunction()

esm_preset_entries(${PROJECT_SOURCE_DIR}/presets fuzzy_entries organ robo-sim susilap-g)
esm_preset_entries(${PROJECT_SOURCE_DIR}/presets/tissue tissue_entries
  liver pancreas kidney spleen myometrium bowel-wall muscle fat brain cartilage
  tube tube-tethers uterus bowel ventricle)
configure_file(embedded_presets.cpp.in embedded_presets.cpp @ONLY)
target_sources(esm_core PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/embedded_presets.cpp)
