/** Colours: display-referred as scene descriptions state them, and linear light; the curve between the two. */
package enlightenment.color;
