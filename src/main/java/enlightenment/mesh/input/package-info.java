/** Reading words and numbers of mesh files, and material libraries (MTL). */
package enlightenment.mesh.input;
