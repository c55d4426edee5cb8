/** A live view of a scene: rendering that starts anew with each change and becomes finer until the next one, on a page of its own. */
package enlightenment.view;
