/** Files that hold a mesh and nothing else, with the materials of OBJ files, as scenes. */
package enlightenment.importer.model;
