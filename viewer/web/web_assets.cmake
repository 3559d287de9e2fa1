# The page's files become strings of the library, in the order in which a page puts them together, and those
# of the desktop's renderer of faces: as they are, but shaders and scripts without lines that are comments
# alone. Sets TRIPUS_WEB_ASSETS_CPP, the source file to compile.
set(TRIPUS_WEB_SHADERS
  common.glsl discs.glsl fullscreen.vert.glsl outside_camera.glsl outside_light.glsl
  outside.vert.glsl
  outside.frag.glsl outside_ground.frag.glsl outside_faces.frag.glsl inside.frag.glsl
  outside_tubes.frag.glsl outside_sky.vert.glsl outside_sky.frag.glsl outside_ball.vert.glsl
  ../faces/faces.vert.glsl ../faces/faces.glsl ../faces/tubes.vert.glsl ../faces/tubes.glsl)
set(TRIPUS_WEB_DESKTOPS
  ../faces/desktop.glsl ../faces/desktop_light.glsl ../faces/desktop.frag.glsl
  ../faces/desktop_tubes.frag.glsl)
set(TRIPUS_WEB_SCRIPTS
  lorentz.js manifold.js palette.js gl.js discs.js outside.js polygons.js faces.js tubes.js cameras.js inside.js
  panel.js controls.js hover.js labels.js dump.js main.js start.js)
set(TRIPUS_WEB_TEXTS
  head.html page.html stage.html controls.html help.html theme.css view.css style.css gallery.html cards.css
  gallery.css)

set(TRIPUS_WEB_ENTRIES "")
foreach(kind Shader Desktop Script Text)
  string(TOUPPER "${kind}S" list)
  foreach(file IN LISTS TRIPUS_WEB_${list})
    set(path "${CMAKE_CURRENT_LIST_DIR}/${file}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
    file(READ "${path}" text)
    if(text MATCHES "\\)tripus\"")
      message(FATAL_ERROR "${file} holds the end mark of a raw string")
    endif()
    if(kind MATCHES "Shader|Script")
      string(REGEX REPLACE "\n *//[^\n]*" "" text "${text}")
    endif()
    get_filename_component(name "${file}" NAME)
    string(APPEND TRIPUS_WEB_ENTRIES
           "    {AssetKind::k${kind}, \"${name}\", R\"tripus(${text})tripus\"},\n")
  endforeach()
endforeach()
set(TRIPUS_WEB_ASSETS_CPP "${CMAKE_CURRENT_BINARY_DIR}/web_assets.cpp")
configure_file("${CMAKE_CURRENT_LIST_DIR}/web_assets.cpp.in" "${TRIPUS_WEB_ASSETS_CPP}" @ONLY)
