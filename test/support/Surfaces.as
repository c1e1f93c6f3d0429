package support
{
    import starlogo.models.Model;

    /** What tests measure of a model's surface. */
    public final class Surfaces
    {
        /** Six numbers: least x, y, z, largest x, y, z. */
        public static function bounds(vertices:Vector.<Number>):Vector.<Number>
        {
            var result:Vector.<Number> = new <Number>[Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
            for (var i:int = 0; i < vertices.length; i++)
            {
                result[i % 3] = Math.min(result[i % 3], vertices[i]);
                result[3 + i % 3] = Math.max(result[3 + i % 3], vertices[i]);
            }
            return result;
        }

        /** The volume that a closed surface encloses; positive if its triangles turn left seen from outside. */
        public static function volume(model:Model):Number
        {
            var v:Vector.<Number> = model.vertices;
            var t:Vector.<uint> = model.triangles;
            var sum:Number = 0;
            for (var i:int = 0; i < t.length; i += 3)
            {
                var a:int = 3 * t[i];
                var b:int = 3 * t[i + 1];
                var c:int = 3 * t[i + 2];
                sum += v[a] * (v[b + 1] * v[c + 2] - v[b + 2] * v[c + 1]) + v[a + 1] * (v[b +
                            2] * v[c] - v[b] * v[c + 2]) +
                    v[a + 2] * (v[b] * v[c + 1] - v[b + 1] * v[c]);
            }
            return sum / 6;
        }

        /** The sum of the areas of triangles. */
        public static function area(vertices:Vector.<Number>, triangles:Vector.<uint>):Number
        {
            var sum:Number = 0;
            for (var i:int = 0; i < triangles.length; i += 3)
            {
                sum += triangleArea(vertices, 3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]);
            }
            return sum;
        }

        /** The centroid of triangles' area. */
        public static function centroid(vertices:Vector.<Number>, triangles:Vector.<uint>):Array
        {
            var sum:Array = [0, 0, 0];
            for (var i:int = 0; i < triangles.length; i += 3)
            {
                var area:Number = triangleArea(vertices, 3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]);
                for (var corner:int = 0; corner < 9; corner++)
                {
                    sum[corner % 3] += area / 3 * vertices[3 * triangles[i + int(corner / 3)] + corner % 3];
                }
            }
            var total:Number = Surfaces.area(vertices, triangles);
            return [sum[0] / total, sum[1] / total, sum[2] / total];
        }

        private static function triangleArea(v:Vector.<Number>, a:int, b:int, c:int):Number
        {
            var ux:Number = v[b] - v[a];
            var uy:Number = v[b + 1] - v[a + 1];
            var uz:Number = v[b + 2] - v[a + 2];
            var wx:Number = v[c] - v[a];
            var wy:Number = v[c + 1] - v[a + 1];
            var wz:Number = v[c + 2] - v[a + 2];
            var nx:Number = uy * wz - uz * wy;
            var ny:Number = uz * wx - ux * wz;
            var nz:Number = ux * wy - uy * wx;
            return Math.sqrt(nx * nx + ny * ny + nz * nz) / 2;
        }

        /** Whether each edge, by its ends' positions, is passed as often one way as the other. */
        public static function isClosed(model:Model):Boolean
        {
            var counts:Object = {};
            for (var i:int = 0; i < model.triangles.length; i++)
            {
                var next:int = i % 3 == 2 ? i - 2 : i + 1;
                var from:String = position(model, model.triangles[i]);
                var to:String = position(model, model.triangles[next]);
                counts[from + "|" + to] = int(counts[from + "|" + to]) + 1;
                counts[to + "|" + from] = int(counts[to + "|" + from]) - 1;
            }
            for each (var count:int in counts)
            {
                if (count != 0)
                {
                    return false;
                }
            }
            return true;
        }

        private static function position(model:Model, vertex:int):String
        {
            return model.vertices.slice(3 * vertex, 3 * vertex + 3).join(",");
        }
    }
}
