/** Pictures to look colours up in. */
package enlightenment.texture;
