package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Effort;
    import support.Fixtures;

    /**
     * The thesis's paintball game (§2.2): balls of size 0.1, at 0.1 to 100 patches a frame, at a fireman, a turtle and a wall. Whether a
     * ball's whole path hits is found by looking every hundredth of a patch. All that hit give the target their colour and are gone, by the
     * game's handler, and none of those that miss. The rates without sweeps are printed beside it.
     */
    public class PaintballTest
    {
        public static const FIXTURES:Array = ["/assets/fireman.dae", "/assets/bear.obj"];

        private static const SIZE:Number = 0.1;
        private static const SPEEDS:Array = [0.1, 0.3, 1, 2, 5, 20, 100];
        private static const LENGTH:Number = 9;
        private static const UNPAINTED:Number = -1;

        private static var sGreatLand:GreatLand;

        private var _target:Agent;
        private var _ball:Agent;
        private var _agents:Vector.<Agent>;

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = new GreatLand();
            sGreatLand.addModel(BuiltInModel.sphere());
            sGreatLand.addModel(new ColladaModel("fireman", Fixtures.text(FIXTURES[0])));
            // as good a turtle as any
            sGreatLand.addModel(new ObjModel("turtle", Fixtures.text(FIXTURES[1])));
            sGreatLand.addModel(wall());
        }

        [AfterClass]
        public static function forgetModels():void
        {
            sGreatLand = null;
        }

        [Test]
        public function tightestFits():void
        {
            shootAt("wall", new TightestFitCollider(sGreatLand));
            shootAt("turtle", new TightestFitCollider(sGreatLand));
            shootAt("fireman", new TightestFitCollider(sGreatLand));
        }

        [Test]
        public function hierarchies():void
        {
            shootAt("turtle", new HierarchicalCollider(sGreatLand));
            shootAt("fireman", new HierarchicalCollider(sGreatLand));
        }

        [Test]
        public function triangles():void
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(sGreatLand);
            collider.exact = true;
            shootAt("wall", collider);
            shootAt("fireman", collider);
        }

        [Test]
        public function aMainCharacterAmongBalls():void
        {
            shootAt("fireman", new CombinationCollider(sGreatLand));
        }

        private function shootAt(shape:String, collider:Collider):void
        {
            var random:SeededRandom = new SeededRandom(701);
            _target = new Agent(shape, "targets");
            _target.heading = 20;
            _target.hierarchical = true;
            _ball = new Agent("sphere", "paintballs");
            var game:Collision = new Collision(collider);
            game.onCollision("targets", "paintballs", paint);
            var rows:Array = [];
            for each (var speed:Number in SPEEDS)
            {
                var hits:int = 0;
                var misses:int = 0;
                var swept:int = 0;
                var standing:int = 0;
                var shots:int = Effort.choose(1, 60);
                while (hits < shots || misses < shots / 2)
                {
                    var shot:Shot = new Shot(random, LENGTH);
                    var surely:int = pathHits(collider, shot, SIZE * 0.98) ? 1 : (pathHits(collider, shot, SIZE * 1.02) ? 0 : -1);
                    if (surely == 0)
                    {
                        // it grazes
                        continue;
                    }
                    // where the frames fall is chance
                    shot.before = random.next() * speed;
                    var isFound:Boolean = fly(game, shot, speed, true);
                    assertEquals(shape + " at " + speed + ": " + shot, surely > 0, isFound);
                    if (surely > 0)
                    {
                        hits++;
                        swept += isFound ? 1 : 0;
                        standing += fly(game, shot, speed, false) ? 1 : 0;
                    }
                    else
                    {
                        misses++;
                    }
                }
                rows.push(speed + ": " + (100 * swept / hits).toFixed(0) + " (" + (100 * standing / hits).toFixed(0) + ")");
            }
            trace("  " + shape + ", " + collider + ", patches a frame: % of hits found (without sweeps): " + rows.join(", "));
        }

        // Between two places that are a hundredth apart, a ball of this size misses a 200th of its radius at most.
        private function pathHits(collider:Collider, shot:Shot, size:Number):Boolean
        {
            _ball.size = size;
            for (var distance:Number = 0; distance <= LENGTH; distance += 0.01)
            {
                placeBall(shot, distance, size, false);
                if (collider.areColliding(_ball, _target))
                {
                    return true;
                }
            }
            return false;
        }

        // Whether the ball has painted the target.
        private function fly(game:Collision, shot:Shot, speed:Number, sweeps:Boolean):Boolean
        {
            _ball.size = SIZE;
            _ball.sweeps = sweeps;
            _ball.color++;
            _target.color = UNPAINTED;
            _agents = new <Agent>[_target, _ball];
            placeBall(shot, -shot.before, SIZE, true);
            game.update(_agents);
            for (var distance:Number = speed - shot.before; distance < LENGTH + speed && _agents.length == 2; distance += speed)
            {
                placeBall(shot, distance, SIZE, false);
                game.update(_agents);
            }
            assertEquals("a ball that hits is gone", _target.color == UNPAINTED ? 2 : 1, _agents.length);
            assertTrue("the target has the ball's own colour", _target.color == UNPAINTED || _target.color == _ball.color);
            return _target.color != UNPAINTED;
        }

        private function paint(target:Agent, ball:Agent):void
        {
            target.color = ball.color;
            _agents.splice(_agents.indexOf(ball), 1);
        }

        // Its middle, whatever its size.
        private function placeBall(shot:Shot, distance:Number, size:Number, jumps:Boolean):void
        {
            var x:Number = shot.x + distance * shot.directionX;
            var y:Number = shot.y + distance * shot.directionY;
            var z:Number = shot.z + distance * shot.directionZ - size / 2;
            if (jumps)
            {
                _ball.jumpTo(x, y, z);
            }
            else
            {
                _ball.moveTo(x, y, z);
            }
        }

        // One patch wide and 0.05 thick.
        private static function wall():Model
        {
            var vertices:Vector.<Number> = BuiltInModel.cube().vertices.concat();
            for (var i:int = 1; i < vertices.length; i += 3)
            {
                vertices[i] *= 0.05;
            }
            return new Model("wall", vertices, BuiltInModel.cube().triangles);
        }
    }
}

import evaluation.pairs.RandomStructures;
import evaluation.pairs.SeededRandom;
import flash.geom.Vector3D;

/** A path through the neighbourhood of the target, longer than that on both sides. */
class Shot
{
    public var x:Number;
    public var y:Number;
    public var z:Number;
    public var directionX:Number;
    public var directionY:Number;
    public var directionZ:Number;
    public var before:Number = 0;

    public function Shot(random:SeededRandom, length:Number)
    {
        var direction:Vector3D = new RandomStructures(random).direction();
        directionX = direction.x;
        directionY = direction.y;
        directionZ = direction.z;
        x = random.between(-0.6, 0.6) - length / 2 * directionX;
        y = random.between(-0.6, 0.6) - length / 2 * directionY;
        z = random.between(-0.2, 2) - length / 2 * directionZ;
    }

    public function toString():String
    {
        return "from " + [x, y, z] + " along " + [directionX, directionY, directionZ] + ", " + before + " before";
    }
}
