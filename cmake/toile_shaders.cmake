# The files of server/render/glsl as a source of server/render: sky.glsl is shaders::kSky, depth_vertex.glsl is
# shaders::kDepthVertex. Literals are raw, with a delimiter that no shader of ours holds.
function(toile_shaders OUT)
  file(GLOB FILES CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/server/render/glsl/*.glsl)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${FILES})
  set(ENTRIES "")
  foreach(FILE ${FILES})
    get_filename_component(STEM ${FILE} NAME_WE)
    string(REPLACE "_" ";" WORDS ${STEM})
    set(NAME k)
    foreach(WORD ${WORDS})
      string(SUBSTRING ${WORD} 0 1 FIRST)
      string(SUBSTRING ${WORD} 1 -1 REST)
      string(TOUPPER ${FIRST} FIRST)
      string(APPEND NAME ${FIRST}${REST})
    endforeach()
    file(READ ${FILE} TEXT)
    string(APPEND ENTRIES "const char* const ${NAME} = R\"glsl(\n${TEXT})glsl\";\n")
  endforeach()
  file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT
       "#include \"server/render/shaders.h\"

namespace toile::render::shaders {

@ENTRIES@
}  // namespace toile::render::shaders
")
endfunction()
