/** Materials as rendering reads them: a BSDF, a medium and what a surface emits, with colours as numbers. */
package enlightenment.world.material;
