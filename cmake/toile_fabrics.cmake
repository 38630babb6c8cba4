# The files of fabrics/ as a source of core/fabric: the program knows its fabrics wherever it runs, and a file more in
# that folder is a fabric more. Literals are raw, with a delimiter that no JSON text of ours holds.
function(toile_fabrics OUT)
  file(GLOB FILES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/fabrics/*.json)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${FILES})
  set(ENTRIES "")
  foreach(FILE ${FILES})
    get_filename_component(NAME ${FILE} NAME_WE)
    file(READ ${FILE} TEXT)
    string(APPEND ENTRIES "    {\"${NAME}\", R\"toile(${TEXT})toile\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT
       "#include \"core/fabric/library.h\"

namespace toile::fabric {

std::span<const FabricFile> fabric_files() {
  static constexpr FabricFile kFiles[] = {
@ENTRIES@  };
  return kFiles;
}

}  // namespace toile::fabric
")
endfunction()
