// The film of fire and ice, for comparing what frames cost (docs/guide/animation.md): the same room, images and ways; clock 0..1 is the film.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 10 }
camera { perspective location <0,1,-3> right 6*x up 3*y direction <0,0.5,3> }
// the window spans x -3..3, y 0..3 at z=0: centre 1.5, so shift the view by a matrix
light_source { <0,1,1> color rgb 1 area_light 0.3*x,0.3*y,2,2 circular orient jitter
  looks_like { sphere { 0, 0.15 pigment { color rgb 1 } finish { ambient 1 diffuse 0 } } } }
#declare F = finish { ambient 0.5 diffuse 0.5 }
#macro Img(N) pigment { image_map { png N map_type 1 interpolate 2 } } #end
#macro Wal(N) pigment { image_map { png N interpolate 2 } } #end
sphere { 0, 1.5 Img("ice.png") finish { F } rotate 360*clock*y translate <-2,1,4> }
sphere { 0, 1.5 Img("fire.png") finish { F } rotate 360*clock*y translate <2,1,4> }
sphere { <-2+4*clock,3.5,4>, 0.75 pigment { color rgb 1 } finish { ambient 0 diffuse 0 reflection 1 } }
plane { z, 8 pigment { image_map { png "wall-back.png" interpolate 2 } scale 12 translate <-6,-6,0> } finish { F } }
plane { x, 6 pigment { image_map { png "wall-right.png" interpolate 2 } rotate 90*y scale 12 translate <0,-6,8> } finish { F } }
plane { x, -6 pigment { image_map { png "wall-left.png" interpolate 2 } rotate 90*y scale 12 translate <0,-6,8> } finish { F } }
plane { y, -6 pigment { image_map { png "floor.png" interpolate 2 } rotate 90*x scale 12 translate <-6,0,-2> } finish { F } }
plane { y, 6 pigment { image_map { png "sky.png" interpolate 2 } rotate 90*x scale 12 translate <-6,0,-2> } finish { ambient 1 diffuse 0 } }
