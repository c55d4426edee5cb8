/** JSON trees with the line and column of each value: strict parser, pointers, edits of the text, and printer. */
package enlightenment.scene.json.tree;
