/**
 * The picture in the making: {@link enlightenment.film.FilmTile} sums the samples of a rectangle of pixels, {@link
 * enlightenment.film.Film} keeps the finished ones, {@link enlightenment.film.ErrorEstimate} tells from the samples alone how far
 * the picture is from the truth. Internal.
 */
package enlightenment.film;
