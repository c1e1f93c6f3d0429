package starlogo.terrain
{
    /**
     * The heights of a picture's pixels, the bottom row first. White gets exactly the height of white.
     *
     * @param picture in Flash a BitmapData, in JavaScript an ImageData
     * @param data of the picture, four bytes for each pixel; null if it has none
     * @param white the height of white
     * @private
     */
    internal function greysOf(picture:Object, data:Object, white:Number):Vector.<Number>
    {
        var greys:Vector.<Number> = new Vector.<Number>();
        for (var row:int = picture.height - 1; row >= 0; row--)
        {
            for (var column:int = 0; column < picture.width; column++)
            {
                var at:int = 4 * (row * picture.width + column);
                var color:uint = data == null ? picture.getPixel(column, row) : data[at] << 16 | data[at + 1] << 8 | data[at + 2];
                var sum:int = (color >> 16 & 255) + (color >> 8 & 255) + (color & 255);
                // white without the rounding of the division
                var grey:Number = sum == 765 ? white : white / 765 * sum;
                greys.push(grey);
            }
        }
        return greys;
    }
}
