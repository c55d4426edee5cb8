/**
 * Descriptions of what surfaces do with light and where their colours come from: immutable records. Image files are named
 * here, not read.
 */
package enlightenment.material;
