/**
 * The picture in the making. Where pixels own their samples, {@link enlightenment.film.FilmTile} sums those of a rectangle, {@link
 * enlightenment.film.TilePasses} puts it together from passes, {@link enlightenment.film.Film} keeps what is finished. Where paths may
 * reach any pixel, {@link enlightenment.film.SplatBatch} sums what some of them contribute and {@link enlightenment.film.SplatFilm} what
 * all do. {@link enlightenment.film.ErrorEstimate} tells from the samples alone how far the picture is from the truth. Internal.
 */
package enlightenment.film;
