/** JSON as a tree whose values know their line and column: parsed strictly, pointed into, edited in place and printed. */
package enlightenment.scene.json.tree;
