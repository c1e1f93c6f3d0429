package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.steps.StepSequence;
    import support.Complaints;
    import support.Effort;
    import support.EveryTriangle;
    import support.FrameByFrame;
    import support.PlainDistance;
    import support.QuestionModels;
    import support.QuestionWorld;

    use namespace engine;

    /** The answers to the questions of QuestionWorld fit one another, loops over everything, and the rules of nesting. */
    public class QuestionVerdictsTest
    {
        public static const FIXTURES:Array = QuestionModels.FIXTURES;

        // As far as rounding may lead.
        private static const NEAR:Number = 1e-9;

        // Distances of structures and triangles are exact to 1e-15 of the sizes, which are up to 8.
        private static const NESTED:Number = 1e-14;

        private var _wrong:Complaints = new Complaints();
        private var _checks:int = 0;
        private var _what:String;

        // By rule: how often it was met by a case that could break it.
        private var _met:Object = {};

        // By system: what the world of the round comes to.
        private var _verdicts:Object;

        [Test(async, timeout="3600000")]
        public function answersFit():void
        {
            var kinds:int = QuestionModels.NAMES.length;
            var count:int = kinds * Effort.choose(1, 20);
            var i:int = 0;
            var asking:StepSequence = new StepSequence().repeat(function():Boolean
                {
                    checkRound(QuestionModels.NAMES[i % kinds], 7 * i + 3);
                    return ++i < count;
                });
            FrameByFrame.run(this, asking, 50, function():void
                {
                    trace("  " + _checks + " checks of answers");
                    _wrong.assertNone();
                    for each (var rule:String in ["touch", "apart", "edge", "ground", "nested touch", "nested distance", "nested ray", "nested way", "free move", "move", "triangles", "ball", "sight"])
                    {
                        assertTrue(rule + " " + _met[rule], _met[rule] >= count / 6);
                    }
                });
        }

        private function checkRound(kind:String, seed:int):void
        {
            var names:Array = [kind, "cube", new SeededRandom(seed).pick(QuestionModels.NAMES)];
            var land:GreatLand = QuestionModels.land(names, false);
            _verdicts = {};
            for each (var system:String in QuestionWorld.SYSTEMS)
            {
                var world:QuestionWorld = new QuestionWorld(land, system);
                world.begin(names, seed);
                _what = names + ", " + system + ", " + seed;
                checkTouches(world);
                checkDistances(world, system);
                checkPlaces(world);
                checkSight(world);
                checkBall(world);
                _verdicts[system] = verdictsOf(world);
                checkMotions(world, names, seed, system);
            }
            checkNesting(names + ", " + seed);
        }

        private function check(isRight:Boolean, rule:String, detail:String = ""):void
        {
            _checks++;
            _wrong.addIf(!isRight, rule, _what + " " + detail);
        }

        private function meet(rule:String):void
        {
            _met[rule] = int(_met[rule]) + 1;
        }

        // A frame finds the pairs that a loop finds, and so does touching().
        private function checkTouches(world:QuestionWorld):void
        {
            world.ask("update");
            var found:Object = {};
            for each (var pair:Array in world.pairs)
            {
                var key:String = world.nameOf(pair[0]) + " " + world.nameOf(pair[1]);
                check(!found[key], "each pair comes once", key);
                found[key] = true;
            }
            var touching:Vector.<Agent> = world.queries.touching(world.agents[0]);
            for (var i:int = 0; i < world.agents.length; i++)
            {
                var a:Agent = world.agents[i];
                for (var k:int = i + 1; k < world.agents.length; k++)
                {
                    var isTouching:Boolean = world.collider.areColliding(a, world.agents[k]);
                    meet(isTouching ? "touch" : "apart");
                    check(isTouching == found.hasOwnProperty(i + " " + k), "a frame finds what a loop finds", i + " " + k);
                    check(isTouching == world.collider.areColliding(world.agents[k], a), "either order", i + " " + k);
                    check(i > 0 || isTouching == touching.indexOf(world.agents[k]) >= 0, "touching() lists what a loop finds", i + " " + k);
                }
                var isAtEdge:Boolean = world.queries.touchesEdge(a, world.bounds);
                check(isAtEdge == found.hasOwnProperty(i + " edges"), "a frame finds who is at the edges", String(i));
                check(isAtEdge == (world.queries.distance(a, world.bounds.agent) == 0), "who is at the edges has no distance from them", String(i));
                if (isAtEdge)
                {
                    meet("edge");
                }
                if (world.terrain != null)
                {
                    var isInGround:Boolean = found.hasOwnProperty(i + " ground");
                    check(isInGround == (world.queries.distance(a, world.terrain.agent) == 0), "who is in the ground has no distance from it", String(i));
                    if (isInGround)
                    {
                        meet("ground");
                    }
                }
            }
            var me:Agent = world.agents[0];
            check(world.queries.touchesAny(me) == touching.length > 0, "touchesAny");
            check(world.queries.wouldTouchAt(me, me.x, me.y, me.z) == touching.length > 0, "wouldTouchAt the present place");
        }

        // Agents that touch have no distance, and only they. In exact mode it is that of the triangles.
        private function checkDistances(world:QuestionWorld, system:String):void
        {
            var me:Agent = world.agents[0];
            for (var i:int = 1; i < world.agents.length; i++)
            {
                var other:Agent = world.agents[i];
                var a:Vector3D = new Vector3D();
                var b:Vector3D = new Vector3D();
                var distance:Number = world.queries.distance(me, other, a, b);
                var isTouching:Boolean = world.collider.areColliding(me, other);
                check(isTouching == (distance == 0), "distance 0 is a touch", i + ": " + distance);
                check(Math.abs(Vector3D.distance(a, b) - distance) < NEAR, "the points are as far apart as the distance", i + ": " + distance);
                check(world.queries.distance(other, me) == distance, "the distance in the other order", i + ": " + distance);
                if (system == "triangles" && QuestionModels.SMALL.indexOf(me.shape) >= 0 && QuestionModels.SMALL.indexOf(other.shape) >= 0)
                {
                    var plain:Number = ofTriangles(me, other);
                    meet("triangles");
                    check(isTouching ? plain < NEAR || isOneInside(world, me, other) : Math.abs(plain - distance) < NEAR, "the distance of all triangles", i + ": " + distance + " for " + plain);
                    check(isTouching || plain > 1e-13, "triangles that touch are a touch", i + ": " + plain);
                }
            }
        }

        private static function ofTriangles(a:Agent, b:Agent):Number
        {
            var ofA:Vector.<Number> = cornersOf(a);
            var ofB:Vector.<Number> = cornersOf(b);
            var least:Number = Infinity;
            for (var i:int = 0; i < ofA.length; i += 9)
            {
                for (var k:int = 0; k < ofB.length; k += 9)
                {
                    least = Math.min(least, PlainDistance.ofTriangles(ofA, i, ofB, k));
                }
            }
            return least;
        }

        // Whether a vertex of one of the two is inside of the other: its ray along z meets the other.
        private static function isOneInside(world:QuestionWorld, a:Agent, b:Agent):Boolean
        {
            return hasVertexIn(world, a, b) || hasVertexIn(world, b, a);
        }

        private static function hasVertexIn(world:QuestionWorld, outer:Agent, inner:Agent):Boolean
        {
            var corners:Vector.<Number> = cornersOf(inner);
            for (var i:int = 0; i < corners.length; i += 3)
            {
                var from:Vector3D = new Vector3D(corners[i], corners[i + 1], corners[i + 2]);
                for each (var hit:RayHit in world.queries.castAll(from, new Vector3D(0.3, 0.2, 1)))
                {
                    if (hit.agent === outer && hit.distance == 0)
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        private static function cornersOf(agent:Agent):Vector.<Number>
        {
            var corners:Vector.<Number> = new Vector.<Number>();
            var model:Model = QuestionModels.of(agent.shape);
            EveryTriangle.place(agent.freshPlacement(), model, corners);
            return corners;
        }

        // Questions about places are answered as a loop would.
        private function checkPlaces(world:QuestionWorld):void
        {
            var me:Agent = world.agents[0];
            var near:Vector.<Agent> = world.queries.near(me, 1.5);
            var nearest:Number = Infinity;
            for (var i:int = 1; i < world.agents.length; i++)
            {
                var distance:Number = distanceOf(me, world.agents[i]);
                nearest = Math.min(nearest, distance);
                check(distance <= 1.5 == near.indexOf(world.agents[i]) >= 0, "near() lists what a loop finds", i + ": " + distance);
            }
            check(near.length == world.queries.countNear(me, 1.5), "countNear counts what near lists");
            for (i = 1; i < near.length; i++)
            {
                check(distanceOf(me, near[i - 1]) <= distanceOf(me, near[i]), "near() is sorted");
            }
            check(distanceOf(me, world.queries.nearest(me)) == nearest, "nearest() is what a loop finds");
        }

        private static function distanceOf(a:Agent, b:Agent):Number
        {
            return Math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
        }

        // Rays and lines of sight, against those that meet one agent alone.
        private function checkSight(world:QuestionWorld):void
        {
            var all:Vector.<RayHit> = world.queries.castAll(world.origin, world.direction);
            var one:RayHit = world.queries.cast(world.origin, world.direction);
            check((all.length == 0) == (one == null) && (one == null || all[0].agent === one.agent && all[0].distance == one.distance), "cast is the first of castAll");
            for (var i:int = 1; i < all.length; i++)
            {
                check(all[i - 1].distance <= all[i].distance, "castAll is sorted");
            }
            for each (var hit:RayHit in all)
            {
                var alone:RayHit = world.queries.cast(world.origin, world.direction, Infinity, only(hit.agent));
                check(alone != null && alone.distance == hit.distance, "a ray meets each agent as if it were alone", world.nameOf(hit.agent));
            }
            for (i = 1; i < world.agents.length; i++)
            {
                var sees:Boolean = world.queries.canSee(world.agents[0], world.agents[i]);
                var isFree:Boolean = true;
                for each (var between:Agent in world.agents)
                {
                    isFree &&= world.queries.canSee(world.agents[0], world.agents[i], only(between));
                }
                isFree &&= world.terrain == null || world.queries.canSee(world.agents[0], world.agents[i], only(world.terrain.agent));
                check(sees == isFree, "sight is free if each agent leaves it free", String(i));
                check(sees == world.queries.canSee(world.agents[i], world.agents[0]), "sight is mutual", String(i));
                if (!sees)
                {
                    meet("sight");
                }
            }
        }

        private static function only(agent:Agent):AgentFilter
        {
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function(other:Agent):Boolean
            {
                return other === agent;
            };
            return filter;
        }

        // A ball overlaps the agents that are no farther from its middle than its radius.
        private function checkBall(world:QuestionWorld):void
        {
            if (!(world.structure is Sphere))
            {
                return;
            }
            var ball:Sphere = Sphere(world.structure);
            var found:Vector.<Agent> = world.queries.overlapping(ball);
            for each (var agent:Agent in world.agents)
            {
                var distance:Number = world.queries.distanceToPoint(agent, ball.center);
                meet("ball");
                check(Math.abs(distance - ball.radius) < NEAR || distance < ball.radius == found.indexOf(agent) >= 0, "a ball overlaps who is near its middle", distance + " for " + ball);
            }
        }

        // What has to be nested: who touches, how far rays go, distances, and how far the agent may go; and about whom triangles decide in exact
        // mode, because all models in question have some.
        private static function verdictsOf(world:QuestionWorld):Object
        {
            var verdicts:Object = {touch: new Object(), ray: new Object(), distance: new Object(), free: NaN, hasTriangles: {all: true}};
            for (var i:int = 0; i < world.agents.length; i++)
            {
                var hasTriangles:Boolean = QuestionModels.of(world.agents[i].shape).triangles != null;
                verdicts.hasTriangles[i] = verdicts.hasTriangles[i + " edges"] = hasTriangles;
                verdicts.hasTriangles.all &&= hasTriangles;
                for (var k:int = i + 1; k < world.agents.length; k++)
                {
                    verdicts.hasTriangles[i + " " + k] = hasTriangles && QuestionModels.of(world.agents[k].shape).triangles != null;
                    verdicts.touch[i + " " + k] = world.collider.areColliding(world.agents[i], world.agents[k]);
                    verdicts.distance[i + " " + k] = world.queries.distance(world.agents[i], world.agents[k]);
                }
                verdicts.touch[i + " edges"] = world.queries.touchesEdge(world.agents[i], world.bounds);
                verdicts.ray[i] = Infinity;
            }
            for each (var hit:RayHit in world.queries.castAll(world.origin, world.direction))
            {
                verdicts.ray[world.nameOf(hit.agent)] = hit.distance;
            }
            return verdicts;
        }

        // The first agent that moves ends where casts say, and no deeper in others than before.
        private function checkMotions(world:QuestionWorld, names:Array, seed:int, system:String):void
        {
            for each (var question:String in ["moveUntilTouch", "slide"])
            {
                world.begin(names, seed);
                var me:Agent = world.agents[0];
                var isFree:Boolean = !world.queries.touchesAny(me);
                var hit:ShapeHit = world.queries.castAgent(me, world.way.x, world.way.y, world.way.z);
                var from:Vector3D = new Vector3D(me.x, me.y, me.z);
                var part:Number = question == "slide" ? world.queries.slide(me, world.way.x, world.way.y, world.way.z)
                    : world.queries.moveUntilTouch(me, world.way.x, world.way.y, world.way.z);
                check(part >= 0 && part <= 1, question + " goes a part of the way", String(part));
                if (!isFree)
                {
                    continue;
                }
                var went:Vector3D = new Vector3D(me.x, me.y, me.z).subtract(from);
                check(went.length <= world.way.length * (1 + NEAR) + NEAR, question + " goes no farther than asked", went.length + " of " + world.way.length);
                meet(hit == null ? "free move" : "move");
                if (question == "moveUntilTouch")
                {
                    _verdicts[system].free = part;
                    check(Math.abs((hit == null ? 1 : hit.time) - part) < 1e-6, "castAgent says how far the agent goes", part + " for " + (hit == null ? 1 : hit.time));
                }
                for (var i:int = 1; i < world.agents.length; i++)
                {
                    var isTouching:Boolean = world.collider.areColliding(me, world.agents[i]);
                    var contact:Contact = isTouching ? world.collider.contactOf(me, world.agents[i]) : null;
                    check(!isTouching || contact.depth < 1e-7, question + " leads into nothing", i + ": " + (isTouching && contact.depth));
                }
            }
        }

        private function checkNesting(what:String):void
        {
            var exact:Object = _verdicts["triangles"];
            for each (var system:String in QuestionWorld.SYSTEMS.slice(1))
            {
                _what = what + ": triangles and " + system;
                checkOuter(exact, _verdicts[system], true);
            }
            _what = what + ": levels 5 and 2";
            checkOuter(_verdicts["hierarchies"], _verdicts["hierarchies to level 2"], false);
        }

        // What the inner system reports, the outer one does too, at the same distance or nearer. Triangles say so only of models that have some.
        private function checkOuter(inner:Object, outer:Object, isExact:Boolean):void
        {
            for (var key:String in inner.hasTriangles)
            {
                if (isExact && !inner.hasTriangles[key])
                {
                    continue;
                }
                if (inner.touch[key] != outer.touch[key])
                {
                    meet("nested touch");
                    check(outer.touch[key], "touches are nested", key);
                }
                if (inner.distance[key] != outer.distance[key])
                {
                    meet("nested distance");
                    check(outer.distance[key] < inner.distance[key] + NESTED, "distances are nested", key + ": " + outer.distance[key] + " and " + inner.distance[key]);
                }
                if (inner.ray[key] != outer.ray[key])
                {
                    meet("nested ray");
                    check(outer.ray[key] < inner.ray[key], "rays are nested", key + ": " + outer.ray[key] + " and " + inner.ray[key]);
                }
                if (key == "all" && inner.free < 1 && outer.free <= 1)
                {
                    meet("nested way");
                    check(outer.free <= inner.free + NEAR, "ways are nested", outer.free + " and " + inner.free);
                }
            }
        }
    }
}
