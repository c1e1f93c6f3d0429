package support
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.models.Model;

    use namespace engine;

    /** What is inside of what, found out with the solid angles of all triangles around each vertex. */
    public final class SolidAngles
    {
        // In the space of the model that it may be inside of.
        private static const POINT:Array = [0, 0, 0];

        // By the model's name, since models are looked at again and again.
        private static var sPieces:Object = {};
        private static var sIsClosed:Object = {};

        /** Whether a piece of one agent, by a vertex of it, is inside of the other's model, if that is closed. */
        public static function isOneInside(a:Agent, modelA:Model, b:Agent, modelB:Model):Boolean
        {
            return hasVertexInside(a, modelA, b, modelB) || hasVertexInside(b, modelB, a, modelA);
        }

        /** How often a model's surface winds around a point of its space. */
        public static function windingAround(model:Model, x:Number, y:Number, z:Number):Number
        {
            var sum:Number = 0;
            var corners:Vector.<Number> = new Vector.<Number>(9, true);
            for (var i:int = 0; i < model.triangles.length; i += 3)
            {
                for (var k:int = 0; k < 3; k++)
                {
                    var at:int = 3 * model.triangles[i + k];
                    corners[3 * k] = model.vertices[at] - x;
                    corners[3 * k + 1] = model.vertices[at + 1] - y;
                    corners[3 * k + 2] = model.vertices[at + 2] - z;
                }
                sum += solidAngle(corners);
            }
            return sum / (4 * Math.PI);
        }

        /** Whether a model's surface closes. */
        public static function closes(model:Model):Boolean
        {
            sIsClosed[model.name] ||= isClosed(model) ? "yes" : "no";
            return sIsClosed[model.name] == "yes";
        }

        private static function hasVertexInside(inner:Agent, innerModel:Model, outer:Agent, outerModel:Model):Boolean
        {
            if (!closes(outerModel))
            {
                return false;
            }
            sPieces[innerModel.name] ||= verticesOfPieces(innerModel);
            for each (var at:int in sPieces[innerModel.name])
            {
                moveInto(inner, innerModel, at, outer);
                if (isNear(outerModel) && Math.abs(windingAround(outerModel, POINT[0], POINT[1], POINT[2])) > 0.5)
                {
                    return true;
                }
            }
            return false;
        }

        // Where one vertex of each piece is: triangles that share a corner's place take over each other's lowest number.
        private static function verticesOfPieces(model:Model):Array
        {
            var pieces:Object = {};
            var hasChanged:Boolean = true;
            while (hasChanged)
            {
                hasChanged = false;
                for (var i:int = 0; i < model.triangles.length; i += 3)
                {
                    var places:Array = [placeOf(model, i), placeOf(model, i + 1), placeOf(model, i + 2)];
                    var least:int = i;
                    for each (var place:String in places)
                    {
                        least = pieces[place] === undefined ? least : Math.min(least, pieces[place]);
                    }
                    for each (place in places)
                    {
                        hasChanged ||= pieces[place] !== least;
                        pieces[place] = least;
                    }
                }
            }
            var vertices:Array = [];
            for (i = 0; i < model.triangles.length; i += 3)
            {
                if (pieces[placeOf(model, i)] == i)
                {
                    vertices.push(3 * model.triangles[i]);
                }
            }
            return vertices;
        }

        // Along every edge as many triangles run one way as the other.
        private static function isClosed(model:Model):Boolean
        {
            var balances:Object = {};
            for (var i:int = 0; i < model.triangles.length; i++)
            {
                var from:String = placeOf(model, i);
                var to:String = placeOf(model, i % 3 == 2 ? i - 2 : i + 1);
                var edge:String = from < to ? from + "," + to : to + "," + from;
                balances[edge] = int(balances[edge]) + (from < to ? 1 : -1);
            }
            for each (var balance:int in balances)
            {
                if (balance != 0)
                {
                    return false;
                }
            }
            return true;
        }

        private static function placeOf(model:Model, corner:int):String
        {
            var at:int = 3 * model.triangles[corner];
            return model.vertices[at] + " " + model.vertices[at + 1] + " " + model.vertices[at + 2];
        }

        private static function isNear(model:Model):Boolean
        {
            for (var axis:int = 0; axis < 3; axis++)
            {
                var isBelow:Boolean = true;
                var isAbove:Boolean = true;
                for (var i:int = axis; i < model.vertices.length && (isBelow || isAbove); i += 3)
                {
                    isBelow &&= POINT[axis] < model.vertices[i];
                    isAbove &&= POINT[axis] > model.vertices[i];
                }
                if (isBelow || isAbove)
                {
                    return false;
                }
            }
            return true;
        }

        private static function moveInto(agent:Agent, model:Model, at:int, outer:Agent):void
        {
            var from:Placement = agent.freshPlacement();
            var to:Placement = outer.freshPlacement();
            var x:Number = from.size * model.vertices[at];
            var y:Number = from.size * model.vertices[at + 1];
            var z:Number = from.size * model.vertices[at + 2];
            var worldX:Number = from.r00 * x + from.r01 * y + from.r02 * z + from.x - to.x;
            var worldY:Number = from.r10 * x + from.r11 * y + from.r12 * z + from.y - to.y;
            var worldZ:Number = from.r20 * x + from.r21 * y + from.r22 * z + from.z - to.z;
            POINT[0] = (to.r00 * worldX + to.r10 * worldY + to.r20 * worldZ) / to.size;
            POINT[1] = (to.r01 * worldX + to.r11 * worldY + to.r21 * worldZ) / to.size;
            POINT[2] = (to.r02 * worldX + to.r12 * worldY + to.r22 * worldZ) / to.size;
        }

        // Van Oosterom and Strackee.
        private static function solidAngle(c:Vector.<Number>):Number
        {
            var volume:Number = c[0] * (c[4] * c[8] - c[5] * c[7]) + c[1] * (c[5] * c[6] - c[3] * c[8]) + c[2] * (c[3] * c[7] - c[4] * c[6]);
            var ab:Number = c[0] * c[3] + c[1] * c[4] + c[2] * c[5];
            var bc:Number = c[3] * c[6] + c[4] * c[7] + c[5] * c[8];
            var ca:Number = c[6] * c[0] + c[7] * c[1] + c[8] * c[2];
            var a:Number = Math.sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
            var b:Number = Math.sqrt(c[3] * c[3] + c[4] * c[4] + c[5] * c[5]);
            var d:Number = Math.sqrt(c[6] * c[6] + c[7] * c[7] + c[8] * c[8]);
            return 2 * Math.atan2(volume, a * b * d + ab * d + bc * a + ca * b);
        }
    }
}
