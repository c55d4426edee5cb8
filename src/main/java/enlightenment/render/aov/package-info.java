/** What pixels are beside their colour, made into pictures to look at. */
package enlightenment.render.aov;
