/** Scenes and models in the formats of other programs. */
package enlightenment.importer;
