package soak
{
    import evaluation.pairs.SeededRandom;
    import starlogo.geometry.Trigonometry;
    import support.Collada;

    /** A random closed solid as turned on a lathe, of some dozen vertices. */
    internal final class Lathe
    {
        /** x, y, z, ... */
        internal var vertices:Vector.<Number> = new Vector.<Number>();

        /** Three indices each. */
        internal var triangles:Vector.<uint> = new Vector.<uint>();

        /**
         * @param random decides
         */
        public function Lathe(random:SeededRandom)
        {
            var sides:int = random.integer(3, 8);
            var rings:int = random.integer(1, 5);
            for (var ring:int = 0; ring < rings; ring++)
            {
                var radius:Number = random.between(0.2, 1);
                for (var side:int = 0; side < sides; side++)
                {
                    var angle:Number = 360 * side / sides;
                    vertices.push(radius * Trigonometry.cosine(angle), radius * Trigonometry.sine(angle), ring);
                }
            }
            vertices.push(0, 0, -random.between(0.1, 1), 0, 0, rings - 1 + random.between(0.1, 1));
            for (side = 0; side < sides; side++)
            {
                addColumn(side, (side + 1) % sides, sides, rings);
            }
        }

        /** As OBJ. */
        internal function toObj():String
        {
            var text:String = "";
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                text += "v " + vertices[i].toFixed(6) + " " + vertices[i + 1].toFixed(6) + " " + vertices[i + 2].toFixed(6) + "\n";
            }
            for (i = 0; i < triangles.length; i += 3)
            {
                text += "f " + (triangles[i] + 1) + " " + (triangles[i + 1] + 1) + " " + (triangles[i + 2] + 1) + "\n";
            }
            return text;
        }

        /** As COLLADA. */
        internal function toCollada():String
        {
            return Collada.document(Collada.geometry("a", vertices.join(" "), Collada.triangles(triangles.join(" "))), "", Collada.Z_UP);
        }

        private function addColumn(side:int, next:int, sides:int, rings:int):void
        {
            var bottom:int = sides * rings;
            triangles.push(bottom, next, side);
            for (var ring:int = 1; ring < rings; ring++)
            {
                var below:int = (ring - 1) * sides;
                var above:int = ring * sides;
                triangles.push(below + side, below + next, above + next, below + side, above + next, above + side);
            }
            triangles.push(bottom + 1, (rings - 1) * sides + side, (rings - 1) * sides + next);
        }
    }
}
