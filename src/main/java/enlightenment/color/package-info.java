/** Colours as scene descriptions state them: display-referred, sRGB-encoded, 0 to 1. */
package enlightenment.color;
