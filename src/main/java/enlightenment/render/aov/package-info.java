/** Pictures that show auxiliary images: depth, normals, objects, errors. */
package enlightenment.render.aov;
