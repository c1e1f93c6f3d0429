package support
{
    import starlogo.terrain.Terrain;

    /**
     * Sets all heights of a terrain.
     *
     * @param heightOf called with column and row
     */
    public function fillHeights(terrain:Terrain, heightOf:Function):void
    {
        var heights:Vector.<Number> = new Vector.<Number>();
        for (var i:int = 0; i < terrain.columns * terrain.rows; i++)
        {
            heights.push(heightOf(i % terrain.columns, int(i / terrain.columns)));
        }
        terrain.setHeights(0, 0, terrain.columns, terrain.rows, heights);
    }
}
