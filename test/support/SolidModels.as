package support
{
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;

    /** Solids that are harder than one closed surface. */
    public final class SolidModels
    {
        /** The names of what is made here. */
        public static const NAMES:Array = ["hollow", "crossed", "apart", "open cube", "doll"];

        /** Those, the built-in cube and the built-in sphere. */
        public static function all():Array
        {
            return [BuiltInModel.cube(), BuiltInModel.sphere(), hollow(), crossed(), apart(), openCube(), doll()];
        }

        /** A cube with a cube in it whose faces are turned inwards: a thick wall around a hollow. */
        public static function hollow():Model
        {
            return of("hollow", [[1, 0, 0, 0, false], [0.7, 0, 0, 0.15, true]]);
        }

        /** Two cubes that run into each other, and a third in both. */
        public static function crossed():Model
        {
            return of("crossed", [[0.7, 0, 0, 0, false], [0.7, 0.3, 0.2, 0.4, false], [0.1, 0.15, 0.1, 0.5, false]]);
        }

        /** Three cubes apart. */
        public static function apart():Model
        {
            return of("apart", [[0.5, 0, 0, 0, false], [0.2, 0.8, 0, 0, false], [0.4, 0, 0.1, 0.8, false]]);
        }

        /** A cube with two small cubes in a row beside it. */
        public static function plank():Model
        {
            return of("plank", [[1, 0, 0, 0, false], [0.2, 0.9, 0, 0, false], [0.2, 1.4, 0.1, 0, false]]);
        }

        /** A hollow cube with a cube in its hollow. */
        public static function doll():Model
        {
            return of("doll", [[1, 0, 0, 0, false], [0.8, 0, 0, 0.1, true], [0.5, 0.1, 0, 0.2, false]]);
        }

        /** A cube without half of a side. */
        public static function openCube():Model
        {
            var cube:Model = BuiltInModel.cube();
            return new Model("open cube", cube.vertices, cube.triangles.slice(3));
        }

        /** A pyramid on a rectangle, thin if it is low. */
        public static function wedge(name:String, height:Number):Model
        {
            return new Model(name, new <Number>[0, 0, 0, 1, 0, 0, 1, 0.4, 0, 0, 0.4, 0, 0.5, 0.2, height],
                    new <uint>[0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 0, 2, 1, 0, 3, 2]);
        }

        /** A wedge whose lowest edge is level, along x. */
        public static function keel():Model
        {
            return new Model("keel", new <Number>[-0.5, 0, 0, 0.5, 0, 0, -0.5, -0.4, 0.8, 0.5, -0.4, 0.8, -0.5, 0.4, 0.8, 0.5, 0.4, 0.8],
                    new <uint>[0, 2, 3, 0, 3, 1, 0, 1, 5, 0, 5, 4, 2, 4, 5, 2, 5, 3, 0, 4, 2, 1, 3, 5], Model.AS_GIVEN);
        }

        /** A floor of 8 by 8 squares of two triangles each, which rises along y. */
        public static function floor(slope:Number):Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var y:int = -4; y <= 4; y++)
            {
                for (var x:int = -4; x <= 4; x++)
                {
                    var i:uint = vertices.length / 3;
                    vertices.push(x, y, slope * y);
                    if (x < 4 && y < 4)
                    {
                        triangles.push(i, i + 1, i + 10, i, i + 10, i + 9);
                    }
                }
            }
            return new Model("floor", vertices, triangles, Model.AS_GIVEN);
        }

        /**
         * A model of cubes.
         *
         * @param name of the model
         * @param cubes size, x, y, z, and whether it is turned inside out
         * @param scaling as the Model's
         */
        public static function of(name:String, cubes:Array, scaling:String = "footprint"):Model
        {
            var cube:Model = BuiltInModel.cube();
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for each (var part:Array in cubes)
            {
                var first:uint = vertices.length / 3;
                for (var i:int = 0; i < cube.vertices.length; i++)
                {
                    vertices.push(part[0] * cube.vertices[i] + part[1 + i % 3]);
                }
                for (i = 0; i < cube.triangles.length; i += 3)
                {
                    triangles.push(first + cube.triangles[i], first + cube.triangles[i + (part[4] ? 2 : 1)],
                            first + cube.triangles[i + (part[4] ? 1 : 2)]);
                }
            }
            return new Model(name, vertices, triangles, scaling);
        }
    }
}
