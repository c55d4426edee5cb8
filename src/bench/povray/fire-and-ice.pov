// Fire and ice in plain colours, for comparing speed (docs/notes/benchmarks.md): the same geometry, light and camera.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 5 }
camera { location <0, 1, -3> direction <0, 0.5, 3> right <6, 0, 0> up <0, 3, 0> }
light_source {
  <0, 1, 1> rgb 1
  area_light <0.3, 0, 0>, <0, 0.3, 0>, 7, 7 circular orient
}
sphere { <0, 1, 1>, 0.15 pigment { rgb 1 } finish { ambient 1 diffuse 0 } no_shadow }
#macro Plain(R, G, B) pigment { rgb <R, G, B> / 255 } finish { ambient 0.5 diffuse 0.5 } #end
sphere { <-2, 1, 4>, 1.5 Plain(150, 190, 230) }
sphere { <2, 1, 4>, 1.5 Plain(230, 120, 20) }
sphere { <0, 3, 4>, 0.75 pigment { rgb 1 } finish { ambient 0 diffuse 0 reflection 1 } }
#macro Wall(A, B, C, D) mesh { triangle { A, B, C } triangle { A, C, D } } #end
object { Wall(<-6, -6, 8>, <-6, 6, 8>, <6, 6, 8>, <6, -6, 8>) Plain(150, 150, 150) }
object { Wall(<6, -6, -2>, <6, 6, -2>, <6, 6, 8>, <6, -6, 8>) Plain(160, 110, 60) }
object { Wall(<-6, -6, -2>, <-6, -6, 8>, <6, -6, 8>, <6, -6, -2>) Plain(200, 200, 200) }
object { Wall(<-6, -6, -2>, <-6, 6, -2>, <-6, 6, 8>, <-6, -6, 8>) Plain(180, 70, 50) }
object { Wall(<-6, 6, -2>, <-6, 6, 8>, <6, 6, 8>, <6, 6, -2>) Plain(100, 150, 220) }
