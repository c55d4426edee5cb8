/** Scene files (JSON): read, written, and described by a schema. */
package enlightenment.scene.json;
