/** What readers of foreign formats share: the scene in the making, notes of what was left out, affine maps, files within a folder. */
package enlightenment.importer.support;
