package support
{
    import evaluation.pairs.SeededRandom;
    import starlogo.terrain.Terrain;

    /** Seeded random terrains of kinds that are hard each in its own way. */
    public final class RandomGround
    {
        /** The kinds that <code>make()</code> knows. */
        public static const KINDS:Array = ["hills", "flat", "steps", "rough", "needle", "wide cells", "small cells", "far out", "long", "holes", "long holes"];

        /** Makes a terrain, of slopes or columns, about the origin but for "far out". */
        public static function make(kind:String, random:SeededRandom):Terrain
        {
            var columns:int = kind == "long" || kind == "long holes" ? random.integer(65, 90) : random.integer(2, 12);
            var rows:int = kind == "long" || kind == "long holes" ? random.integer(2, 3) : random.integer(2, 12);
            var width:Number = kind == "wide cells" ? random.logBetween(5, 50) : kind == "small cells" ? random.logBetween(0.05, 0.3) : random.chance(0.5) ? 1 : random.between(0.5, 2);
            var far:Number = kind == "far out" ? random.integer(-1000000, 1000000) : 0;
            var terrain:Terrain = new Terrain(columns, rows, width, far - columns * width / 2, far - rows * width / 2);
            terrain.isBlocky = random.chance(0.5);
            fillHeights(terrain, function(column:int, row:int):Number
                {
                    return heightOf(kind, column, row, width, random);
                });
            if (kind == "needle")
            {
                terrain.setHeight(random.integer(0, columns - 1), random.integer(0, rows - 1), random.between(50, 1000));
            }
            if (kind == "holes" || kind == "long holes")
            {
                var share:Number = random.pick([0.05, 0.3, 0.6]);
                // the first cell stays
                for (var i:int = 1; i < columns * rows; i++)
                {
                    terrain.setHole(i % columns, i / columns, random.chance(share));
                }
            }
            return terrain;
        }

        private static function heightOf(kind:String, column:int, row:int, width:Number, random:SeededRandom):Number
        {
            if (kind == "flat" || kind == "needle")
            {
                return 0;
            }
            switch (kind)
            {
                case "steps":
                    return random.integer(0, 2) / 2;
                case "rough":
                    return random.between(-3, 3) * width;
                default:
                    return width * ((column * column + 3 * row) % 7) / 7 + random.between(0, width / 4);
            }
        }
    }
}
