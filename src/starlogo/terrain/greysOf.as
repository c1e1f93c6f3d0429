package starlogo.terrain
{
    /**
     * The grey values of a picture's pixels, the bottom row first.
     *
     * @param picture a BitmapData, or an ImageData
     * @param scale the factor of the sum of red, green and blue
     *
     * @private
     */
    public function greysOf(picture:Object, scale:Number):Vector.<Number>
    {
        var greys:Vector.<Number> = new Vector.<Number>();
        for (var row:int = picture.height - 1; row >= 0; row--)
        {
            for (var column:int = 0; column < picture.width; column++)
            {
                var at:int = 4 * (row * picture.width + column);
                var data:Object = "data" in picture ? picture.data : null;
                var color:uint = data == null ? picture.getPixel(column, row) : data[at] << 16 | data[at + 1] << 8 | data[at + 2];
                greys.push(scale * ((color >> 16 & 255) + (color >> 8 & 255) + (color & 255)));
            }
        }
        return greys;
    }
}
