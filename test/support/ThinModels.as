package support
{
    import starlogo.GreatLand;
    import starlogo.models.Model;

    /** Models without volume: points, lines, triangles and planes. */
    public final class ThinModels
    {
        private static const CORNERS:Object = {
                "point": [0, 0, 0],
                "three equal points": [0, 0, 0, 0, 0, 0, 0, 0, 0],
                "two points": [0, 0, 0, 1, 0, 0],
                "line": [0, 0, 0, 1, 0, 0, 0.5, 0, 0],
                "mast": [0, 0, 0, 0, 0, 1],
                "triangle": [0, 0, 0, 1, 0, 0, 0, 1, 0],
                "plane": [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0],
                "wall": [0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1]
            };

        /** The names of what is made here. */
        public static const NAMES:Array = ["point", "three equal points", "two points", "line", "mast", "triangle", "plane", "wall"];

        /** Adds all of them. */
        public static function addTo(greatLand:GreatLand):void
        {
            for each (var name:String in NAMES)
            {
                greatLand.addModel(make(name));
            }
        }

        /** Makes one: the point, the two points and the mast have no triangles. */
        public static function make(name:String):Model
        {
            var vertices:Vector.<Number> = Vector.<Number>(CORNERS[name]);
            var triangles:Vector.<uint> = null;
            if (vertices.length == 9)
            {
                triangles = new <uint>[0, 1, 2];
            }
            else if (vertices.length == 12)
            {
                triangles = new <uint>[0, 1, 2, 0, 2, 3];
            }
            return new Model(name, vertices, triangles);
        }
    }
}
