package enlightenment.importer.mitsuba;

import enlightenment.color.Rgb;
import enlightenment.importer.support.UvMap;
import enlightenment.material.Texture;
import java.util.Optional;

/**
 * What a surface emits.
 *
 * @param radiance before it is multiplied by a texture; not black
 * @param texture what it is multiplied by; empty if all points emit alike
 * @param uv what the texture does to texture coordinates
 */
record AreaEmission(Rgb radiance, Optional<Texture> texture, UvMap uv) {}
